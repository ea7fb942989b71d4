/* NumPy universal functions around generated kernels, given the kernels' addresses.
 *
 * make(name, doc, signature, nin, nout, batch, batchf, owner) -> numpy.ufunc
 * bind(scalar, arrays)                                        -> callable evaluating one configuration in place
 * cpu()                                                       -> best instruction set here: "avx512", "avx2" or "plain"
 *
 * The kernels know nothing of Python; `owner` is the object that keeps their library loaded. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarrayobject.h>
#include <numpy/ufuncobject.h>

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
    if (PyType_Ready(&BoundType) < 0) {
        return NULL;
    }
    return PyModule_Create(&module);
}
