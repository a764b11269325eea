/** An object on a module's heap, which stays there until it is deleted. */
interface ModuleObject {
  delete(): void;
}

/**
 * Deletes an object of a module at the end of `work`, unless the module broke: then all of its
 * memory is freed.
 */
export async function owning<O extends ModuleObject, T>(
  object: O,
  work: (object: O) => T | Promise<T>,
): Promise<T> {
  let broken = false;
  try {
    return await work(object);
  } catch (error) {
    broken = error instanceof WebAssembly.RuntimeError;
    throw error;
  } finally {
    if (!broken) object.delete();
  }
}
