//! The same operations for a WASM host, which has numbers and memory but no command line.
#![cfg(target_arch = "wasm32")]

use crate::operations::{Operation, Task};
use std::cell::RefCell;

thread_local! {
    static TEXTS: RefCell<[Vec<u8>; 4]> = const { RefCell::new([const { Vec::new() }; 4]) };
    static OPERATION: RefCell<Option<Box<dyn Operation>>> = const { RefCell::new(None) };
    static RESULT: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// Room for a text: 0 the scenario, 1 its files, 2 the state, 3 the operation's name. The host writes it.
#[unsafe(no_mangle)]
pub extern "C" fn text(index: usize, length: usize) -> *mut u8 {
    TEXTS.with_borrow_mut(|texts| {
        texts[index] = vec![0; length];
        texts[index].as_mut_ptr()
    })
}

/// Makes the operation from the four texts; 0 where that fails.
#[unsafe(no_mangle)]
pub extern "C" fn prepare() -> u32 {
    let made = TEXTS.with_borrow(|texts| {
        let [scenario, files, state, name] = texts.each_ref().map(|text| String::from_utf8_lossy(text));
        Task::read(&scenario, &files, &state).and_then(|task| task.operation(&name))
    });
    OPERATION.set(made.ok());
    u32::from(OPERATION.with_borrow(Option::is_some))
}

/// Back to the fixed state; 0 where that fails.
#[unsafe(no_mangle)]
pub extern "C" fn reset() -> u32 {
    on_operation(|operation| operation.reset().is_ok())
}

/// Does the operation this many times; 0 where one fails.
#[unsafe(no_mangle)]
pub extern "C" fn repeat(times: usize) -> u32 {
    on_operation(|operation| operation.repeat(times).is_ok())
}

/// Computes the result's numbers and returns how many they are.
#[unsafe(no_mangle)]
pub extern "C" fn result_length() -> usize {
    on_operation(|operation| {
        RESULT.set(operation.result());
        true
    });
    RESULT.with_borrow(Vec::len)
}

/// Where the result's numbers are.
#[unsafe(no_mangle)]
pub extern "C" fn result() -> *const f64 {
    RESULT.with_borrow(|numbers| numbers.as_ptr())
}

fn on_operation(act: impl FnOnce(&mut (dyn Operation + 'static)) -> bool) -> u32 {
    OPERATION.with_borrow_mut(|operation| u32::from(operation.as_deref_mut().is_some_and(act)))
}
