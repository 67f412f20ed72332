/** The page that plays scenes with scripts. */
const PAGE = './player-scripts.html';

/** Whether the page is of an origin of its own, which nothing else belongs to: its scripts reach no stored data. */
export const isSandboxed = (): boolean => self.origin === 'null';

/** Whether a scene file has scripts. */
export function hasScripts(text: string): boolean {
  try {
    const { assets } = JSON.parse(text) as { assets?: readonly { readonly type?: unknown }[] };
    return Array.isArray(assets) && assets.some((asset) => asset?.type === 'script');
  } catch {
    // whoever opens it tells what is wrong
    return false;
  }
}

/** What a player in a frame tells the page around it when its scene is drawn as it stays. */
interface ReadyMessage {
  readonly farol: 'ready';
}

/** Tells the page around this one, if there is one, that the scene is drawn as it stays. */
export function tellReady(): void {
  const message: ReadyMessage = { farol: 'ready' };
  // whoever frames the page sees that it is there anyway
  if (parent !== self) parent.postMessage(message, '*');
}

/** Has a sandboxed frame, as large as the page, show the scene of the address. @returns fulfilled when the frame is ready */
export function showSandboxed(): Promise<void> {
  const frame = document.createElement('iframe');
  frame.setAttribute('sandbox', 'allow-scripts allow-pointer-lock');
  frame.allow = 'autoplay; fullscreen; gamepad';
  frame.src = PAGE + location.hash;
  frame.title = document.title;
  frame.style.cssText = 'position:fixed;inset:0;width:100%;height:100%;border:0';
  document.body.append(frame);
  frame.addEventListener('load', () => frame.focus());
  return new Promise((resolve) => {
    addEventListener('message', ({ source, data }: MessageEvent<Partial<ReadyMessage> | null>) => {
      if (source === frame.contentWindow && data?.farol === 'ready') resolve();
    });
  });
}
