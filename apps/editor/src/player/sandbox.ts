/** URL of the page that plays scenes with scripts. */
const PAGE = './player-scripts.html';

/** Whether the page has an opaque origin, so that its scripts have no access to stored data. */
export const isSandboxed = (): boolean => self.origin === 'null';

/** Whether a scene file has scripts. */
export function hasScripts(text: string): boolean {
  try {
    const { assets } = JSON.parse(text) as { assets?: readonly { readonly type?: unknown }[] };
    return Array.isArray(assets) && assets.some((asset) => asset?.type === 'script');
  } catch {
    // errors are reported when the file is opened
    return false;
  }
}

/** Message to the embedding page when the scene is completely drawn. */
interface ReadyMessage {
  readonly farol: 'ready';
}

/** Tells the embedding page, if any, that the scene is completely drawn. */
export function tellReady(): void {
  const message: ReadyMessage = { farol: 'ready' };
  // the message is sent to any origin, since it reveals nothing
  if (parent !== self) parent.postMessage(message, '*');
}

/** Shows the scene of the URL in a sandboxed frame that fills the page. @returns fulfilled when the frame is ready */
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
