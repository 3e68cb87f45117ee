//! Operations exported to a WASM host, which has numbers and memory but no command line.
#![cfg(target_arch = "wasm32")]

use crate::operations::{Operation, Task};
use std::cell::RefCell;

thread_local! {
    static TEXTS: RefCell<[Vec<u8>; 4]> = const { RefCell::new([const { Vec::new() }; 4]) };
    static OPERATION: RefCell<Option<Box<dyn Operation>>> = const { RefCell::new(None) };
    static RESULT: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// Reserves memory for a text that the host writes: 0 scenario, 1 its files, 2 state, 3 the operation's name.
#[unsafe(no_mangle)]
pub extern "C" fn text(index: usize, length: usize) -> *mut u8 {
    TEXTS.with_borrow_mut(|texts| {
        texts[index] = vec![0; length];
        texts[index].as_mut_ptr()
    })
}

/// Makes the operation from the four texts; returns 0 on failure.
#[unsafe(no_mangle)]
pub extern "C" fn prepare() -> u32 {
    let made = TEXTS.with_borrow(|texts| {
        let [scenario, files, state, name] = texts.each_ref().map(|text| String::from_utf8_lossy(text));
        Task::read(&scenario, &files, &state).and_then(|task| task.operation(&name))
    });
    OPERATION.set(made.ok());
    u32::from(OPERATION.with_borrow(Option::is_some))
}

/// Returns to the fixed state; returns 0 on failure.
#[unsafe(no_mangle)]
pub extern "C" fn reset() -> u32 {
    on_operation(|operation| operation.reset().is_ok())
}

/// Repeats the operation a number of times; returns 0 on failure.
#[unsafe(no_mangle)]
pub extern "C" fn repeat(times: usize) -> u32 {
    on_operation(|operation| operation.repeat(times).is_ok())
}

/// Computes the numbers of the result and returns their count.
#[unsafe(no_mangle)]
pub extern "C" fn result_length() -> usize {
    on_operation(|operation| {
        RESULT.set(operation.result());
        true
    });
    RESULT.with_borrow(Vec::len)
}

/// Returns the address of the result's numbers.
#[unsafe(no_mangle)]
pub extern "C" fn result() -> *const f64 {
    RESULT.with_borrow(|numbers| numbers.as_ptr())
}

fn on_operation(act: impl FnOnce(&mut (dyn Operation + 'static)) -> bool) -> u32 {
    OPERATION.with_borrow_mut(|operation| u32::from(operation.as_deref_mut().is_some_and(act)))
}
