import { shortText } from '@farol/editing';

/** A scene to be handed to another page. */
export interface HandedScene {
  readonly name: string;
  /** A scene file: see `writeContainer`. Asked for each time the other page asks; the bytes are given away. */
  bytes(): Promise<Uint8Array<ArrayBuffer>>;
}

/** `type` of the messages by which one page hands a scene to another. */
export const handoverMessages = {
  /** The opened page asks for the scene. */
  wanted: 'farol-scene-wanted',
  /** The scene: with `name` and `bytes`, an ArrayBuffer. */
  scene: 'farol-scene',
  /** No scene can be sent; `problem` is a sentence that tells why. */
  failed: 'farol-scene-failed',
} as const;

/** Options of `openBeside`. */
export interface OpenBesideOptions {
  /** Page of the app, relative to its address, such as '../guides/lights.html'. Default: the app itself. */
  readonly path?: string;
  /** Fragment of the address, after `#`. */
  readonly fragment?: string;
  /** Handed over when the page asks for it; the address says `?from=` and the own origin then. */
  readonly scene?: HandedScene;
  /** Time after which a page that has not asked is given up (ms). Default 30 s. */
  readonly patience?: number;
  /** Window that opens the page; the global one when absent. */
  readonly host?: Pick<Window, 'open' | 'location' | 'addEventListener' | 'removeEventListener'>;
}

/** Interval (ms) between checks whether the page was closed. */
const LOOK = 2000;

/**
 * Opens another app in a window of its own, found by the file `apps.json` beside the page, and hands it a scene. Call
 * it while a click or a key is answered, or the browser blocks the window. The scene goes to the very window and origin
 * that were opened and to nobody else; a page that is loaded anew gets it again.
 *
 * @param app - key in `apps.json`: 'lab'
 * @param label - what messages call the app: 'the Lab'
 * @throws Error (as a rejection) of a sentence with the mend: the window is blocked, nobody knows where the app is, it
 * does not ask, or the scene cannot be packed
 */
export async function openBeside(
  app: string,
  label: string,
  { path = '', fragment = '', scene, patience = 30_000, host = window }: OpenBesideOptions = {},
): Promise<void> {
  // before any await: later the browser blocks the window as a pop-up
  const page = host.open('about:blank', '_blank');
  if (!page) {
    throw new Error(`The browser blocked the window of ${label}: allow pop-ups for this page, then choose it again.`);
  }
  let address: URL;
  try {
    address = new URL(path, await addressOf(app, label, host.location.href));
  } catch (error) {
    page.close();
    throw error;
  }
  address.hash = fragment;
  if (!scene) {
    page.location.href = address.href;
    return;
  }
  address.searchParams.set('from', host.location.origin);
  const isHanded = handOver(host, page, address, label, scene, patience);
  page.location.href = address.href;
  await isHanded;
}

async function addressOf(app: string, label: string, page: string): Promise<URL> {
  const list = new URL('./apps.json', page);
  let addresses: Record<string, unknown> | null = null;
  try {
    const answer = await fetch(list);
    if (answer.ok) addresses = (await answer.json()) as Record<string, unknown>;
  } catch {
    // a list of addresses that cannot be read counts as none
  }
  const text = addresses?.[app];
  let address: URL | null = null;
  try {
    if (typeof text === 'string') address = new URL(text, list);
  } catch {
    // the listed text is no valid address
  }
  if (!address || !/^https?:$/.test(address.protocol)) {
    throw new Error(`The address of ${label} is unknown: write it into ${shortText(list.href, 120)}.`);
  }
  return address;
}

/** @returns fulfilled when the page has the scene for the first time */
function handOver(
  host: NonNullable<OpenBesideOptions['host']>,
  page: Window,
  { origin, href }: URL,
  label: string,
  scene: HandedScene,
  patience: number,
): Promise<void> {
  return new Promise((resolve, reject) => {
    const end = (): void => {
      host.removeEventListener('message', onMessage);
      clearTimeout(timer);
      clearInterval(look);
    };
    const onMessage = ({ source, origin: from, data }: MessageEvent<{ type?: unknown } | null>): void => {
      if (source !== page || from !== origin || data?.type !== handoverMessages.wanted) return;
      clearTimeout(timer);
      scene.bytes().then(
        ({ buffer }) => {
          page.postMessage({ type: handoverMessages.scene, name: scene.name, bytes: buffer }, origin, [buffer]);
          resolve();
        },
        (error: unknown) => {
          const problem = error instanceof Error ? error.message : String(error);
          page.postMessage({ type: handoverMessages.failed, problem }, origin);
          reject(error instanceof Error ? error : new Error(problem));
        },
      );
    };
    const timer = setTimeout(() => {
      reject(
        new Error(`No answer from ${label} at ${shortText(href, 120)}: is it served there? Then choose it again.`),
      );
    }, patience);
    const look = setInterval(() => {
      if (!page.closed) return;
      end();
      // the user has closed the page: no error
      resolve();
    }, LOOK);
    host.addEventListener('message', onMessage);
  });
}
