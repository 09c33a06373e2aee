//! The functions of FMI 3.0 that an importer calls. Each returns a status of the standard and says in the log
//! why it is not `Ok`.
//!
//! # Safety
//! Of all of them: pointers are those that the standard asks for, and an instance is used by one thread at a
//! time.
// Names and arguments are those of the standard.
#![allow(unsafe_code, non_snake_case, clippy::missing_safety_doc, clippy::too_many_arguments)]

use crate::description::CATEGORIES;
use crate::fmu::Fmu;
use crate::instance::{Instance, Refusal, Saved, Severity};
use std::ffi::{CStr, CString, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::ptr::null_mut;
use std::slice;

/// How a call ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// As asked.
    Ok,
    /// Not quite.
    Warning,
    /// Not at all; nothing has changed.
    Discard,
    /// Not at all; the instance must be reset or set back.
    Error,
    /// Nothing can be done with any instance any more.
    Fatal,
}

/// What takes the messages of an instance.
pub type LogMessage =
    Option<unsafe extern "C" fn(env: *mut c_void, Status, category: *const c_char, message: *const c_char)>;

/// An instance with what the interface keeps for its importer.
pub struct Handle {
    instance: Instance,
    log: Log,
    /// Texts that were asked for, valid until the next call.
    texts: Vec<CString>,
}

#[derive(Clone, Copy)]
struct Log {
    log: LogMessage,
    environment: *mut c_void,
}

impl Log {
    fn line(&self, status: Status, category: usize, message: &str) {
        let Some(log) = self.log else { return };
        let (category, message) = (text(CATEGORIES[category].0), text(message));
        // SAFETY: the importer's own function and environment, and texts that outlast the call.
        unsafe { log(self.environment, status, category.as_ptr(), message.as_ptr()) }
    }
}

/// A text of C; it ends where it holds a zero.
fn text(text: &str) -> CString {
    CString::new(text.split('\0').next().unwrap_or_default()).unwrap_or_default()
}

/// A text of C as an importer gives it.
unsafe fn given(text: *const c_char) -> Result<String, Refusal> {
    if text.is_null() {
        return Err(Refusal::error("a text is missing"));
    }
    // SAFETY: a text of C, as the standard says.
    let text = unsafe { CStr::from_ptr(text) }.to_str();
    text.map(str::to_owned).map_err(|_| Refusal::error("a text is not UTF-8"))
}

/// A list as an importer gives it.
unsafe fn list<'a, T>(first: *const T, number: usize) -> Result<&'a [T], Refusal> {
    match (first.is_null(), number) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(Refusal::error("a list is missing")),
        // SAFETY: a list of this length, as the standard says.
        (false, _) => Ok(unsafe { slice::from_raw_parts(first, number) }),
    }
}

/// A list that is to be filled.
unsafe fn list_mut<'a, T>(first: *mut T, number: usize) -> Result<&'a mut [T], Refusal> {
    match (first.is_null(), number) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(Refusal::error("a list is missing")),
        // SAFETY: a list of this length, as the standard says.
        (false, _) => Ok(unsafe { slice::from_raw_parts_mut(first, number) }),
    }
}

/// Does something with an instance; what goes wrong is in the log and in the status.
unsafe fn with(instance: *mut c_void, act: impl FnOnce(&mut Handle) -> Result<(), Refusal>) -> Status {
    // SAFETY: an instance that was made here, as the standard says.
    let Some(handle) = (unsafe { instance.cast::<Handle>().as_mut() }) else { return Status::Error };
    let log = handle.log;
    let done = catch_unwind(AssertUnwindSafe(|| {
        let done = act(handle);
        handle.instance.notes.drain(..).for_each(|note| log.line(Status::Ok, 1, &note));
        done
    }));
    let (status, message) = match done {
        Ok(Ok(())) => return Status::Ok,
        Ok(Err(Refusal { severity: Severity::Discard, message })) => (Status::Discard, message),
        Ok(Err(Refusal { severity: Severity::Error, message })) => (Status::Error, message),
        Err(_) => (Status::Fatal, "an internal error of Coulter; please report it".to_owned()),
    };
    log.line(status, 0, &message);
    status
}

fn has_no(what: &str) -> Refusal {
    Refusal::error(format!("the FMU has no {what}"))
}

/// Version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Messages are errors and the verdict, which are always said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: *mut c_void,
    _on: bool,
    number: usize,
    categories: *const *const c_char,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |_| {
            for category in list(categories, number)? {
                let category = given(*category)?;
                if CATEGORIES.iter().all(|(known, _)| *known != category) {
                    return Err(has_no(&format!("category {category}")));
                }
            }
            Ok(())
        })
    }
}

/// An instance for co-simulation; null where there can be none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging: bool,
    _event_mode: bool,
    _early_return: bool,
    _intermediate: *const u32,
    _number: usize,
    environment: *mut c_void,
    log: LogMessage,
    _update: *const c_void,
) -> *mut c_void {
    let log = Log { log, environment };
    let made = catch_unwind(AssertUnwindSafe(|| {
        // SAFETY: as that of this function.
        let (token, resources) = unsafe { (given(token)?, given(resources)?) };
        let fmu = Fmu::in_resources(Path::new(&resources));
        Instance::new(fmu.map_err(|error| Refusal::error(error.to_string()))?, &token)
    }));
    match made {
        Ok(Ok(instance)) => Box::into_raw(Box::new(Handle { instance, log, texts: Vec::new() })).cast(),
        Ok(Err(refusal)) => {
            log.line(Status::Error, 0, &refusal.message);
            null_mut()
        }
        Err(_) => {
            log.line(Status::Fatal, 0, "an internal error of Coulter; please report it");
            null_mut()
        }
    }
}

/// The FMU is for co-simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log: LogMessage,
) -> *mut c_void {
    Log { log, environment }.line(Status::Error, 0, "the FMU is for co-simulation, not for model exchange");
    null_mut()
}

/// The FMU is for co-simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log: LogMessage,
    _clock: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> *mut c_void {
    let why = "the FMU is for co-simulation, not for scheduled execution";
    Log { log, environment }.line(Status::Error, 0, why);
    null_mut()
}

/// Frees an instance; a run that was not terminated stops.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut c_void) {
    if !instance.is_null() {
        // SAFETY: an instance that was made here and is not used any more, as the standard says.
        let handle = unsafe { Box::from_raw(instance.cast::<Handle>()) };
        drop(catch_unwind(AssertUnwindSafe(|| drop(handle))));
    }
}

/// Begins initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: *mut c_void,
    _tolerance_defined: bool,
    _tolerance: f64,
    start: f64,
    stop_defined: bool,
    stop: f64,
) -> Status {
    let stop = stop_defined.then_some(stop);
    // SAFETY: as that of this function.
    unsafe { with(instance, |handle| handle.instance.enter_initialization(start, stop)) }
}

/// Ends initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(instance: *mut c_void) -> Status {
    // SAFETY: as that of this function.
    unsafe { with(instance, |handle| handle.instance.exit_initialization()) }
}

/// Ends the run as a finished one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(instance: *mut c_void) -> Status {
    // SAFETY: as that of this function.
    unsafe { with(instance, |handle| handle.instance.terminate()) }
}

/// Back to the beginning.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: *mut c_void) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |handle| {
            handle.instance.reset();
            Ok(())
        })
    }
}

/// A step of the importer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: *mut c_void,
    from: f64,
    step: f64,
    _is_final: bool,
    event: *mut bool,
    terminates: *mut bool,
    early: *mut bool,
    last: *mut f64,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        let status = with(instance, |handle| handle.instance.step(from, step));
        for flag in [event, terminates, early] {
            if let Some(flag) = flag.as_mut() {
                *flag = false;
            }
        }
        if let Some(last) = last.as_mut() {
            *last = if status == Status::Ok { from + step } else { from };
        }
        status
    }
}

/// Numbers by their references.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    instance: *mut c_void,
    references: *const u32,
    number: usize,
    values: *mut f64,
    values_number: usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |handle| {
            same_number(number, values_number)?;
            for (reference, value) in list(references, number)?.iter().zip(list_mut(values, number)?) {
                *value = handle.instance.number(*reference)?;
            }
            Ok(())
        })
    }
}

/// Sets numbers by their references.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    instance: *mut c_void,
    references: *const u32,
    number: usize,
    values: *const f64,
    values_number: usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |handle| {
            same_number(number, values_number)?;
            let mut each = list(references, number)?.iter().zip(list(values, number)?);
            each.try_for_each(|(reference, value)| handle.instance.set_number(*reference, *value))
        })
    }
}

/// Texts by their references, valid until the next call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetString(
    instance: *mut c_void,
    references: *const u32,
    number: usize,
    values: *mut *const c_char,
    values_number: usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |handle| {
            same_number(number, values_number)?;
            let references = list(references, number)?;
            let own = |reference: &u32| handle.instance.text(*reference).map(text);
            handle.texts = references.iter().map(own).collect::<Result<_, _>>()?;
            let values = list_mut(values, number)?;
            values.iter_mut().zip(&handle.texts).for_each(|(value, text)| *value = text.as_ptr());
            Ok(())
        })
    }
}

/// Sets texts by their references.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetString(
    instance: *mut c_void,
    references: *const u32,
    number: usize,
    values: *const *const c_char,
    values_number: usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |handle| {
            same_number(number, values_number)?;
            let mut each = list(references, number)?.iter().zip(list(values, number)?);
            each.try_for_each(|(reference, value)| handle.instance.set_text(*reference, &given(*value)?))
        })
    }
}

fn same_number(references: usize, values: usize) -> Result<(), Refusal> {
    if references == values {
        return Ok(());
    }
    Err(Refusal::error(format!("{values} values for {references} variables, each of one")))
}

/// The state, to be set again and freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: as that of this function; a state that is given is one of those that were made here.
    unsafe {
        with(instance, |handle| {
            let place = state.as_mut().ok_or_else(|| has_no("place for the state"))?;
            let saved = handle.instance.save()?;
            match place.cast::<Saved>().as_mut() {
                Some(before) => *before = saved,
                None => *place = Box::into_raw(Box::new(saved)).cast(),
            }
            Ok(())
        })
    }
}

/// Goes to a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: *mut c_void, state: *mut c_void) -> Status {
    // SAFETY: as that of this function; a state that is given is one of those that were made here.
    unsafe {
        with(instance, |handle| {
            let saved = state.cast::<Saved>().as_ref().ok_or_else(|| has_no("such state"))?;
            handle.instance.restore(saved)
        })
    }
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: as that of this function; a state that is given is one of those that were made here.
    unsafe {
        with(instance, |_| {
            if let Some(place) = state.as_mut().filter(|place| !place.is_null()) {
                drop(Box::from_raw(place.cast::<Saved>()));
                *place = null_mut();
            }
            Ok(())
        })
    }
}

/// A state as bytes.
unsafe fn bytes(state: *mut c_void) -> Result<Vec<u8>, Refusal> {
    // SAFETY: a state that was made here.
    let saved = unsafe { state.cast::<Saved>().as_ref() }.ok_or_else(|| has_no("such state"))?;
    postcard::to_stdvec(saved).map_err(|error| Refusal::error(error.to_string()))
}

/// Number of bytes of a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |_| {
            *size.as_mut().ok_or_else(|| has_no("place for the size"))? = bytes(state)?.len();
            Ok(())
        })
    }
}

/// A state as bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: *mut c_void,
    state: *mut c_void,
    serialized: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |_| {
            let bytes = bytes(state)?;
            if bytes.len() != size {
                return Err(Refusal::error(format!("the state has {} bytes, not {size}", bytes.len())));
            }
            list_mut(serialized, size)?.copy_from_slice(&bytes);
            Ok(())
        })
    }
}

/// The state of these bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: *mut c_void,
    serialized: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Status {
    // SAFETY: as that of this function.
    unsafe {
        with(instance, |_| {
            let saved = postcard::from_bytes::<Saved>(list(serialized, size)?);
            let saved = saved.map_err(|_| Refusal::error("these bytes are no state of an FMU of Coulter"))?;
            let place = state.as_mut().ok_or_else(|| has_no("place for the state"))?;
            *place = Box::into_raw(Box::new(saved)).cast();
            Ok(())
        })
    }
}

/// Functions for what the FMU does not have.
macro_rules! absent {
    ($what:literal: $($name:ident($($argument:ident: $kind:ty),*)),* $(,)?) => {$(
        #[doc = concat!("The FMU has no ", $what, ".")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: *mut c_void, $($argument: $kind),*) -> Status {
            $(let _ = $argument;)*
            // SAFETY: as that of this function.
            unsafe { with(instance, |_| Err(has_no($what))) }
        }
    )*};
}

/// Functions for variables of a type that the FMU does not have: no list of them is not empty.
macro_rules! no_variables {
    ($($name:ident: $kind:ty),* $(,)?) => {$(
        #[doc = "The FMU has no variables of this type."]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            instance: *mut c_void,
            _references: *const u32,
            number: usize,
            _values: *mut $kind,
            _values_number: usize,
        ) -> Status {
            // SAFETY: as that of this function.
            unsafe {
                with(instance, |_| if number == 0 { Ok(()) } else { Err(has_no("variables of this type")) })
            }
        }
    )*};
}

no_variables!(
    fmi3GetFloat32: f32, fmi3GetInt8: i8, fmi3GetUInt8: u8, fmi3GetInt16: i16, fmi3GetUInt16: u16,
    fmi3GetInt32: i32, fmi3GetUInt32: u32, fmi3GetInt64: i64, fmi3GetUInt64: u64, fmi3GetBoolean: bool,
    fmi3SetFloat32: f32, fmi3SetInt8: i8, fmi3SetUInt8: u8, fmi3SetInt16: i16, fmi3SetUInt16: u16,
    fmi3SetInt32: i32, fmi3SetUInt32: u32, fmi3SetInt64: i64, fmi3SetUInt64: u64, fmi3SetBoolean: bool,
);

absent!("binary variables":
    fmi3GetBinary(a: *const u32, b: usize, c: *mut usize, d: *mut *const u8, e: usize),
    fmi3SetBinary(a: *const u32, b: usize, c: *const usize, d: *const *const u8, e: usize),
);
absent!("clocks":
    fmi3GetClock(a: *const u32, b: usize, c: *mut bool),
    fmi3SetClock(a: *const u32, b: usize, c: *const bool),
    fmi3GetIntervalDecimal(a: *const u32, b: usize, c: *mut f64, d: *mut i32),
    fmi3GetIntervalFraction(a: *const u32, b: usize, c: *mut u64, d: *mut u64, e: *mut i32),
    fmi3GetShiftDecimal(a: *const u32, b: usize, c: *mut f64),
    fmi3GetShiftFraction(a: *const u32, b: usize, c: *mut u64, d: *mut u64),
    fmi3SetIntervalDecimal(a: *const u32, b: usize, c: *const f64),
    fmi3SetIntervalFraction(a: *const u32, b: usize, c: *const u64, d: *const u64),
    fmi3SetShiftDecimal(a: *const u32, b: usize, c: *const f64),
    fmi3SetShiftFraction(a: *const u32, b: usize, c: *const u64, d: *const u64),
    fmi3ActivateModelPartition(a: u32, b: f64),
);
absent!("variables whose dependencies change":
    fmi3GetNumberOfVariableDependencies(a: u32, b: *mut usize),
    fmi3GetVariableDependencies(a: u32, b: *mut usize, c: *mut u32, d: *mut usize, e: *mut i32, f: usize),
);
absent!("derivatives":
    fmi3GetDirectionalDerivative(
        a: *const u32, b: usize, c: *const u32, d: usize, e: *const f64, f: usize, g: *mut f64, h: usize
    ),
    fmi3GetAdjointDerivative(
        a: *const u32, b: usize, c: *const u32, d: usize, e: *const f64, f: usize, g: *mut f64, h: usize
    ),
    fmi3GetOutputDerivatives(a: *const u32, b: usize, c: *const i32, d: *mut f64, e: usize),
);
absent!("structural parameters": fmi3EnterConfigurationMode(), fmi3ExitConfigurationMode());
absent!("events":
    fmi3EnterEventMode(),
    fmi3EnterStepMode(),
    fmi3EvaluateDiscreteStates(),
    fmi3UpdateDiscreteStates(a: *mut bool, b: *mut bool, c: *mut bool, d: *mut bool, e: *mut bool, f: *mut f64),
);
absent!("continuous states of its importer":
    fmi3EnterContinuousTimeMode(),
    fmi3CompletedIntegratorStep(a: bool, b: *mut bool, c: *mut bool),
    fmi3SetTime(a: f64),
    fmi3SetContinuousStates(a: *const f64, b: usize),
    fmi3GetContinuousStateDerivatives(a: *mut f64, b: usize),
    fmi3GetEventIndicators(a: *mut f64, b: usize),
    fmi3GetContinuousStates(a: *mut f64, b: usize),
    fmi3GetNominalsOfContinuousStates(a: *mut f64, b: usize),
    fmi3GetNumberOfEventIndicators(a: *mut usize),
    fmi3GetNumberOfContinuousStates(a: *mut usize),
);
