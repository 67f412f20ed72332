/** A scene handed over by another app. */
export interface ReceivedScene {
  readonly name: string;
  /** A scene file of the engine with its assets, for `Stage.setOwnScene`. */
  readonly file: Uint8Array;
}

export interface ReceiveOptions {
  /** Longest wait for the other page (ms). Default 60 s, since packing a large scene takes long. */
  readonly patience?: number;
  /** Window that receives the scene; replaced in tests. */
  readonly host?: Pick<Window, 'opener' | 'location' | 'addEventListener' | 'removeEventListener'>;
}

/** Keys in `apps.json` of the apps that may hand scenes over. */
const senders = ['editor', 'viewer'];

/** Longest name of a scene; longer ones are cut. */
const LONGEST_NAME = 120;

/**
 * Requests the scene of the page that opened this one, if the address names that page's origin as `?from=`. Only
 * origins of the editor and the viewer in `apps.json` are accepted. The file is checked by the engine when a stage
 * opens it; nothing is fetched for it from other addresses.
 *
 * @returns null if the address has no `?from=`
 * @throws Error (as a rejection), a sentence with the remedy: the origin is not accepted, there is no answer, or
 *   packing failed
 */
export async function receiveScene({
  patience = 60_000,
  host = window,
}: ReceiveOptions = {}): Promise<ReceivedScene | null> {
  const from = new URL(host.location.href).searchParams.get('from');
  if (from === null) return null;
  const origins = await originsOf(host.location.href);
  if (!origins.includes(from)) {
    throw new Error(
      `A page of ${from.slice(0, LONGEST_NAME)} offers a scene, and is neither the editor nor the viewer of this Lab: open it from there.`,
    );
  }
  const opener = host.opener as Window | null;
  if (!opener || opener.closed) {
    throw new Error('The page that handed its scene over is gone: choose “Measure this scene” there once more.');
  }
  return new Promise((resolve, reject) => {
    const end = (): void => {
      clearTimeout(timer);
      host.removeEventListener('message', onMessage);
    };
    const onMessage = ({ source, origin, data }: MessageEvent<Record<string, unknown> | null>): void => {
      if (source !== opener || origin !== from) return;
      if (data?.type === 'farol-scene-failed') {
        end();
        reject(new Error(`The scene was not received: ${String(data.problem)}`));
      }
      if (data?.type !== 'farol-scene' || !(data.bytes instanceof ArrayBuffer)) return;
      end();
      const name = typeof data.name === 'string' && data.name ? data.name.slice(0, LONGEST_NAME) : 'Scene';
      resolve({ name, file: new Uint8Array(data.bytes) });
    };
    const timer = setTimeout(() => {
      end();
      reject(new Error('The page that opened the Lab does not answer: choose “Measure this scene” there once more.'));
    }, patience);
    host.addEventListener('message', onMessage);
    opener.postMessage({ type: 'farol-scene-wanted' }, from);
  });
}

/** Origins of the apps that may hand scenes over. */
async function originsOf(page: string): Promise<string[]> {
  const list = new URL('./apps.json', page);
  try {
    const addresses = (await (await fetch(list)).json()) as Record<string, unknown>;
    return senders.flatMap((name) => {
      const text = addresses[name];
      return typeof text === 'string' ? [new URL(text, list).origin] : [];
    });
  } catch {
    return [];
  }
}
