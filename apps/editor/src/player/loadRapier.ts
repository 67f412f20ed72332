import { t } from '@farol/editing';

/** The player's script element; must be read while the script first runs. */
const ownScript = document.currentScript as HTMLScriptElement | null;

/** Replaces the engine's `loadRapier`. Rapier is compressed in the page, or in a script beside the player. */
export function loadRapier(): Promise<object> {
  loading ??= load();
  return loading;
}

let loading: Promise<object> | null = null;

async function load(): Promise<object> {
  const packed = document.getElementById('farol-physics');
  await (packed ? runPacked(packed.textContent) : runBeside());
  const { farolLoadRapier } = globalThis as { farolLoadRapier?: () => Promise<object> };
  if (!farolLoadRapier) throw new Error(t('The page has no physics: export the scene again.'));
  return farolLoadRapier();
}

/** Runs a script. @param base64 - gzip-compressed source */
async function runPacked(base64: string): Promise<void> {
  const bytes = Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const script = document.createElement('script');
  // the nonce is required by the page's Content-Security-Policy
  script.nonce = ownScript?.nonce ?? '';
  script.textContent = await new Response(stream).text();
  document.head.append(script);
}

function runBeside(): Promise<void> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    script.src = new URL('farol-player-physics.js', ownScript?.src ?? document.baseURI).href;
    script.addEventListener('load', () => resolve());
    script.addEventListener('error', () => reject(new Error(t('The physics could not be loaded: reload the page.'))));
    document.head.append(script);
  });
}
