/* NumPy universal functions around generated kernels, given the kernels' addresses.
 *
 * make(name, doc, signature, nin, nout, batch, batchf, owner) -> numpy.ufunc
 * call(batch, batchf, nin, shapes, owner, general)            -> callable with a short way for one configuration
 * bind(batch, arrays, owner)                                  -> callable evaluating one configuration in place
 * cpu()                                                       -> best instruction set here: "avx512", "avx2" or "plain"
 *
 * The kernels know nothing of Python; `owner` is the object that keeps their library loaded. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarrayobject.h>
#include <numpy/ufuncobject.h>

#include <fenv.h>
#include <stddef.h>

#define MOST_ARGS 16

typedef void (*Batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* What the loop of one type needs; a ufunc owns two of these. */
typedef struct {
    Batch kernel;
} Loop;

typedef struct {
    PyUFuncGenericFunction functions[2];
    void *data[2];
    Loop loops[2];
    char types[2 * MOST_ARGS];
} Spec;

static const char SPEC_NAME[] = "chainrule.gufunc";

/* dimensions[0] is the number of configurations; steps are byte strides in the kernel's own order. */
static void loop(char **args, npy_intp const *dimensions, npy_intp const *steps, void *data)
{
    ((const Loop *)data)->kernel((ptrdiff_t)dimensions[0], args, (const ptrdiff_t *)steps);
    /* Kernels compute both sides of a choice, and nan and infinity are answers: NumPy need not warn of either. */
    if (fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW)) {
        feclearexcept(FE_ALL_EXCEPT);
    }
}

static void release(PyObject *capsule)
{
    PyObject *owner = (PyObject *)PyCapsule_GetContext(capsule);
    PyMem_Free(PyCapsule_GetPointer(capsule, SPEC_NAME));
    Py_XDECREF(owner);
}

static PyObject *make(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *name, *doc, *signature, *owner;
    int nin, nout;
    unsigned long long batch, batchf;
    if (!PyArg_ParseTuple(arguments, "UUUiiKKO", &name, &doc, &signature, &nin, &nout, &batch, &batchf, &owner)) {
        return NULL;
    }
    const int nargs = nin + nout;
    if (nin < 1 || nout < 1 || nargs > MOST_ARGS || batch == 0 || batchf == 0) {
        PyErr_SetString(PyExc_ValueError, "a kernel has 1 to 16 arguments and two addresses");
        return NULL;
    }
    Spec *spec = PyMem_Calloc(1, sizeof *spec);
    if (spec == NULL) {
        return PyErr_NoMemory();
    }
    /* float first: the first loop to which the input converts safely is taken, and double would take everything. */
    spec->loops[0].kernel = (Batch)(uintptr_t)batchf;
    spec->loops[1].kernel = (Batch)(uintptr_t)batch;
    for (int k = 0; k < 2; ++k) {
        spec->functions[k] = loop;
        spec->data[k] = &spec->loops[k];
        for (int i = 0; i < nargs; ++i) {
            spec->types[k * nargs + i] = k == 0 ? NPY_FLOAT : NPY_DOUBLE;
        }
    }
    PyObject *capsule = PyCapsule_New(spec, SPEC_NAME, release);
    if (capsule == NULL) {
        PyMem_Free(spec);
        return NULL;
    }
    /* The ufunc keeps pointers into name and doc, so both live as long as the capsule does. */
    PyObject *kept = PyTuple_Pack(4, owner, name, doc, signature);
    if (kept == NULL || PyCapsule_SetContext(capsule, kept) != 0) {
        Py_XDECREF(kept);
        Py_DECREF(capsule);
        return NULL;
    }
    const char *c_name = PyUnicode_AsUTF8(name), *c_doc = PyUnicode_AsUTF8(doc);
    const char *c_signature = PyUnicode_AsUTF8(signature);
    PyObject *result = NULL;
    if (c_name != NULL && c_doc != NULL && c_signature != NULL) {
        result = PyUFunc_FromFuncAndDataAndSignature(spec->functions, spec->data, spec->types, 2, nin, nout, PyUFunc_None,
                                                     c_name, c_doc, 0, c_signature);
    }
    if (result == NULL) {
        Py_DECREF(capsule);
        return NULL;
    }
    ((PyUFuncObject *)result)->obj = capsule; /* released with the ufunc */
    return result;
}

/* One configuration, in place: the arrays' addresses are taken once. */
typedef struct {
    PyObject_HEAD
    vectorcallfunc call;
    Batch kernel;
    int count;
    PyObject *arrays;
    PyObject *owner;
    char *args[MOST_ARGS];
    ptrdiff_t steps[MOST_ARGS * 3];
} Bound;

static PyObject *bound_call(PyObject *self, PyObject *const *args, size_t nargsf, PyObject *names)
{
    (void)args;
    Bound *bound = (Bound *)self;
    if (PyVectorcall_NARGS(nargsf) != 0 || names != NULL) {
        PyErr_SetString(PyExc_TypeError, "a bound evaluation takes no arguments: it reads and writes the arrays it was made with");
        return NULL;
    }
    bound->kernel(1, bound->args, bound->steps);
    Py_RETURN_NONE;
}

static void bound_free(PyObject *self)
{
    Bound *bound = (Bound *)self;
    Py_XDECREF(bound->arrays);
    Py_XDECREF(bound->owner);
    Py_TYPE(self)->tp_free(self);
}

static PyTypeObject BoundType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "chainrule._gufunc.Bound",
    .tp_doc = "Evaluates one configuration: reads its input arrays and writes its output arrays.",
    .tp_basicsize = sizeof(Bound),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_vectorcall_offset = offsetof(Bound, call),
    .tp_call = PyVectorcall_Call,
    .tp_dealloc = bound_free,
};

/* The caller has checked shapes and types: arrays is a tuple of double (or float) arrays of the kernel's shapes. */
static PyObject *bind(PyObject *self, PyObject *arguments)
{
    (void)self;
    unsigned long long batch;
    PyObject *arrays, *owner;
    if (!PyArg_ParseTuple(arguments, "KO!O", &batch, &PyTuple_Type, &arrays, &owner)) {
        return NULL;
    }
    const Py_ssize_t count = PyTuple_GET_SIZE(arrays);
    if (batch == 0 || count < 2 || count > MOST_ARGS) {
        PyErr_SetString(PyExc_ValueError, "a kernel has an address and 2 to 16 arguments");
        return NULL;
    }
    Bound *bound = (Bound *)BoundType.tp_alloc(&BoundType, 0);
    if (bound == NULL) {
        return NULL;
    }
    bound->call = bound_call;
    bound->kernel = (Batch)(uintptr_t)batch;
    bound->arrays = Py_NewRef(arrays);
    bound->owner = Py_NewRef(owner);
    int step = (int)count; /* steps between configurations stay 0: there is one */
    for (Py_ssize_t i = 0; i < count; ++i) {
        PyObject *item = PyTuple_GET_ITEM(arrays, i);
        if (!PyArray_Check(item) || PyArray_NDIM((PyArrayObject *)item) > 2) {
            Py_DECREF(bound);
            PyErr_SetString(PyExc_TypeError, "bind takes NumPy arrays of at most two axes");
            return NULL;
        }
        PyArrayObject *array = (PyArrayObject *)item;
        bound->args[i] = PyArray_BYTES(array);
        for (int axis = 0; axis < PyArray_NDIM(array); ++axis) {
            bound->steps[step++] = (ptrdiff_t)PyArray_STRIDE(array, axis);
        }
    }
    return (PyObject *)bound;
}

/* A call that takes the short way where every input is one configuration of exactly the kernel's shape and type, and
 * otherwise leaves everything to `general` (the ufunc behind its checks). NumPy's own machinery costs microseconds. */
typedef struct {
    PyObject_HEAD
    vectorcallfunc call;
    Batch kernels[2]; /* double, float */
    int nin, nargs;
    int axes[MOST_ARGS];
    npy_intp shapes[MOST_ARGS][2];
    PyObject *general;
    PyObject *owner;
} Call;

/* Whether an object is an array of this type and exactly this shape that the kernel can use as it lies. */
static int fits(PyObject *item, int type, int axes, const npy_intp *shape, int writeable)
{
    if (!PyArray_CheckExact(item)) {
        return 0;
    }
    PyArrayObject *array = (PyArrayObject *)item;
    if (PyArray_TYPE(array) != type || PyArray_NDIM(array) != axes
        || !(writeable ? PyArray_ISBEHAVED(array) : PyArray_ISBEHAVED_RO(array))) {
        return 0;
    }
    for (int k = 0; k < axes; ++k) {
        if (PyArray_DIM(array, k) != shape[k]) {
            return 0;
        }
    }
    return 1;
}

static PyObject *call_call(PyObject *self, PyObject *const *args, size_t nargsf, PyObject *names)
{
    Call *const call = (Call *)self;
    const Py_ssize_t given = PyVectorcall_NARGS(nargsf);
    if (names != NULL || (given != call->nin && given != call->nargs) || !PyArray_CheckExact(args[0])) {
        return PyObject_Vectorcall(call->general, args, nargsf, names);
    }
    const int type = PyArray_TYPE((PyArrayObject *)args[0]);
    if (type != NPY_DOUBLE && type != NPY_FLOAT) {
        return PyObject_Vectorcall(call->general, args, nargsf, names);
    }
    PyObject *arrays[MOST_ARGS];
    char *data[MOST_ARGS];
    ptrdiff_t steps[MOST_ARGS * 3] = {0};
    for (int i = 0; i < (int)given; ++i) {
        if (!fits(args[i], type, call->axes[i], call->shapes[i], i >= call->nin)) {
            return PyObject_Vectorcall(call->general, args, nargsf, names);
        }
        arrays[i] = Py_NewRef(args[i]);
    }
    for (int i = (int)given; i < call->nargs; ++i) {
        arrays[i] = PyArray_SimpleNew(call->axes[i], call->shapes[i], type);
        if (arrays[i] == NULL) {
            while (i-- > 0) {
                Py_DECREF(arrays[i]);
            }
            return NULL;
        }
    }
    int step = call->nargs;
    for (int i = 0; i < call->nargs; ++i) {
        PyArrayObject *array = (PyArrayObject *)arrays[i];
        data[i] = PyArray_BYTES(array);
        for (int k = 0; k < call->axes[i]; ++k) {
            steps[step++] = (ptrdiff_t)PyArray_STRIDE(array, k);
        }
    }
    call->kernels[type == NPY_FLOAT](1, data, steps);
    for (int i = 0; i < call->nin; ++i) {
        Py_DECREF(arrays[i]);
    }
    const int nout = call->nargs - call->nin;
    /* As a ufunc does: new results without axes are scalars, given ones are returned as they are. */
    for (int i = call->nin; i < call->nargs && given == call->nin; ++i) {
        arrays[i] = PyArray_Return((PyArrayObject *)arrays[i]);
    }
    if (nout == 1) {
        return arrays[call->nin];
    }
    PyObject *result = PyTuple_New(nout);
    for (int i = 0; i < nout; ++i) {
        if (result == NULL) {
            Py_XDECREF(arrays[call->nin + i]);
        } else {
            PyTuple_SET_ITEM(result, i, arrays[call->nin + i]);
        }
    }
    return result;
}

static void call_free(PyObject *self)
{
    Call *call = (Call *)self;
    PyObject_GC_UnTrack(self);
    Py_XDECREF(call->general);
    Py_XDECREF(call->owner);
    Py_TYPE(self)->tp_free(self);
}

static int call_traverse(PyObject *self, visitproc visit, void *arg)
{
    Py_VISIT(((Call *)self)->general);
    Py_VISIT(((Call *)self)->owner);
    return 0;
}

static int call_clear(PyObject *self)
{
    Py_CLEAR(((Call *)self)->general);
    Py_CLEAR(((Call *)self)->owner);
    return 0;
}

static PyTypeObject CallType = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "chainrule._gufunc.Call",
    .tp_doc = "Evaluates a kernel: one configuration directly, anything else through NumPy.",
    .tp_basicsize = sizeof(Call),
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL | Py_TPFLAGS_HAVE_GC,
    .tp_vectorcall_offset = offsetof(Call, call),
    .tp_call = PyVectorcall_Call,
    .tp_traverse = call_traverse,
    .tp_clear = call_clear,
    .tp_dealloc = call_free,
};

/* shapes: a tuple with one tuple of at most two extents for each argument. */
static PyObject *make_call(PyObject *self, PyObject *arguments)
{
    (void)self;
    unsigned long long batch, batchf;
    int nin;
    PyObject *shapes, *owner, *general;
    if (!PyArg_ParseTuple(arguments, "KKiO!OO", &batch, &batchf, &nin, &PyTuple_Type, &shapes, &owner, &general)) {
        return NULL;
    }
    const Py_ssize_t count = PyTuple_GET_SIZE(shapes);
    if (batch == 0 || batchf == 0 || nin < 1 || count <= nin || count > MOST_ARGS) {
        PyErr_SetString(PyExc_ValueError, "a kernel has two addresses and 2 to 16 arguments");
        return NULL;
    }
    Call *call = (Call *)CallType.tp_alloc(&CallType, 0);
    if (call == NULL) {
        return NULL;
    }
    call->call = call_call;
    call->kernels[0] = (Batch)(uintptr_t)batch;
    call->kernels[1] = (Batch)(uintptr_t)batchf;
    call->nin = nin;
    call->nargs = (int)count;
    call->general = Py_NewRef(general);
    call->owner = Py_NewRef(owner);
    for (Py_ssize_t i = 0; i < count; ++i) {
        PyObject *shape = PyTuple_GET_ITEM(shapes, i);
        if (!PyTuple_Check(shape) || PyTuple_GET_SIZE(shape) > 2) {
            Py_DECREF(call);
            PyErr_SetString(PyExc_TypeError, "a shape is a tuple of at most two extents");
            return NULL;
        }
        call->axes[i] = (int)PyTuple_GET_SIZE(shape);
        for (Py_ssize_t k = 0; k < PyTuple_GET_SIZE(shape); ++k) {
            call->shapes[i][k] = (npy_intp)PyLong_AsSsize_t(PyTuple_GET_ITEM(shape, k));
        }
    }
    if (PyErr_Occurred()) {
        Py_DECREF(call);
        return NULL;
    }
    return (PyObject *)call;
}

static PyObject *cpu(PyObject *self, PyObject *unused)
{
    (void)self;
    (void)unused;
    const char *best = "plain";
#if (defined(__GNUC__) || defined(__clang__)) && (defined(__x86_64__) || defined(__i386__))
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        best = "avx2";
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
            && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
            best = "avx512";
        }
    }
#endif
    return PyUnicode_FromString(best);
}

static PyMethodDef methods[] = {
    {"make", make, METH_VARARGS, "A NumPy universal function of a kernel's two batch entries."},
    {"call", make_call, METH_VARARGS, "A call of a kernel with a short way for one configuration."},
    {"bind", bind, METH_VARARGS, "One configuration of a kernel on fixed arrays."},
    {"cpu", cpu, METH_NOARGS, "The best instruction set of this processor: avx512, avx2 or plain."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef module = {
    PyModuleDef_HEAD_INIT, "_gufunc", "NumPy universal functions around generated kernels.", -1, methods,
    NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__gufunc(void)
{
    import_array();
    import_umath();
    if (PyType_Ready(&BoundType) < 0 || PyType_Ready(&CallType) < 0) {
        return NULL;
    }
    return PyModule_Create(&module);
}
