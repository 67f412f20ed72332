import { shortText } from '@farol/editing';

/** A scene to pass to another page. */
export interface HandedScene {
  readonly name: string;
  /** Makes a scene file (see `writeContainer`); called for each request, since the bytes are transferred. */
  bytes(): Promise<Uint8Array<ArrayBuffer>>;
}

/** `type` of the messages by which one page passes a scene to another. */
export const handoverMessages = {
  /** Request of the opened page for the scene. */
  wanted: 'farol-scene-wanted',
  /** The scene: with `name` and `bytes`, an ArrayBuffer. */
  scene: 'farol-scene',
  /** No scene can be sent; `problem` is a sentence with the reason. */
  failed: 'farol-scene-failed',
} as const;

/** Options of `openBeside`. */
export interface OpenBesideOptions {
  /** Page of the app, relative to its address, such as '../guides/lights.html'. Default: the app itself. */
  readonly path?: string;
  /** Fragment of the address, after `#`. */
  readonly fragment?: string;
  /** Scene passed to the page on request; the address then gets `?from=` with the present origin. */
  readonly scene?: HandedScene;
  /** Time (ms) to wait for the page's request. Default 30 s. */
  readonly patience?: number;
  /** Window that opens the page; the global one when absent. */
  readonly host?: Pick<Window, 'open' | 'location' | 'addEventListener' | 'removeEventListener'>;
}

/** Interval (ms) between checks whether the page was closed. */
const LOOK = 2000;

/**
 * Opens another app in a window, at the address that the file `apps.json` beside the page gives, and passes it a scene.
 * Call it in the handler of a click or key, or the browser blocks the window. The scene is sent only to the opened
 * window and origin, again after a reload.
 *
 * @param app - key in `apps.json`: 'lab'
 * @param label - name of the app in messages: 'the Lab'
 * @throws Error (as a rejection) of a sentence with the mend: the window is blocked, `apps.json` lacks the app, the
 *   page sends no request, or the scene cannot be packed
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
    // an unreadable `apps.json` counts as empty
  }
  const text = addresses?.[app];
  let address: URL | null = null;
  try {
    if (typeof text === 'string') address = new URL(text, list);
  } catch {
    // an invalid address in `apps.json` counts as none
  }
  if (!address || !/^https?:$/.test(address.protocol)) {
    throw new Error(`The address of ${label} is unknown: write it into ${shortText(list.href, 120)}.`);
  }
  return address;
}

/** @returns a promise that resolves once the page has the scene */
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
