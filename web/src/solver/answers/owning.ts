/** What lives on a module's heap until it is deleted. */
interface ModuleObject {
  delete(): void;
}

/** Deletes an object of a module when `work` has ended, unless the module broke: all of its memory goes then. */
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
