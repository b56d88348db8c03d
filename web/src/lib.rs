//! groundwave in a page: a request comes in as JSON text, an answer goes out. No physics.
//!
//! Three C functions are all that WebAssembly needs, and no binding generator. A page writes its request where `take` says, calls
//! `answer`, and reads as many bytes where `give` says. Their memory belongs to this side and stays until the next call.

mod opened;
mod reply;

use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static REPLY: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Where a request of `length` bytes of JSON is to be written.
#[expect(unsafe_code, reason = "a name for the page; no other function of the module has it")]
#[unsafe(no_mangle)]
pub extern "C" fn take(length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        request.clear();
        request.resize(length, 0);
        request.as_mut_ptr()
    })
}

/// Answers the request, and says how many bytes of JSON the reply has.
#[expect(unsafe_code, reason = "a name for the page; no other function of the module has it")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    let reply = REQUEST.with_borrow(|request| reply::to(request).to_string());
    let length = reply.len();
    REPLY.set(reply.into_bytes());
    length
}

/// Where the reply stands.
#[expect(unsafe_code, reason = "a name for the page; no other function of the module has it")]
#[unsafe(no_mangle)]
pub extern "C" fn give() -> *const u8 {
    REPLY.with_borrow(|reply| reply.as_ptr())
}
