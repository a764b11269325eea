/** Conditions under which a page may work without a request of its user. */

/** Least charge of a battery that is not being charged, as a share. */
const leastCharge = 0.3;

interface Battery {
  readonly charging: boolean;
  readonly level: number;
}

/** Parts of `navigator` that only some browsers have. */
interface Device {
  readonly connection?: {readonly saveData?: boolean};
  readonly getBattery?: () => Promise<Battery>;
}

const hasPage = (): boolean => typeof document !== 'undefined';

/** Returns whether the device saves neither data nor its battery. */
export async function maySpend(): Promise<boolean> {
  if (!hasPage()) return true;
  const device = navigator as Navigator & Device;
  const saves = device.connection?.saveData ?? false;
  if (saves || matchMedia('(prefers-reduced-data: reduce)').matches) return false;
  const battery = await device.getBattery?.().catch(() => undefined);
  return !battery || battery.charging || battery.level > leastCharge;
}

/** Waits until the page is visible, or until the signal fires. */
function visible(signal: AbortSignal): Promise<void> {
  if (!hasPage() || !document.hidden || signal.aborted) return Promise.resolve();
  return new Promise((resolve) => {
    const listening = new AbortController();
    const end = (): void => {
      if (document.hidden && !signal.aborted) return;
      listening.abort();
      resolve();
    };
    document.addEventListener('visibilitychange', end, {signal: listening.signal});
    signal.addEventListener('abort', end, {signal: listening.signal});
  });
}

/**
 * Runs work while the page is visible. The work ends when the page is hidden, and begins again once
 * it is visible.
 * @throws errors of the work; the signal's reason
 */
export async function whileVisible<T>(
  signal: AbortSignal,
  work: (signal: AbortSignal) => Promise<T>,
): Promise<T> {
  for (;;) {
    await visible(signal);
    signal.throwIfAborted();
    const hidden = new AbortController();
    const hide = (): void => {
      if (document.hidden) hidden.abort();
    };
    if (hasPage()) document.addEventListener('visibilitychange', hide);
    try {
      return await work(AbortSignal.any([signal, hidden.signal]));
    } catch (error) {
      if (!hidden.signal.aborted || signal.aborted) throw error;
    } finally {
      if (hasPage()) document.removeEventListener('visibilitychange', hide);
    }
  }
}
