/** The player's script element; must be read while the script first runs. */
const ownScript = document.currentScript as HTMLScriptElement | null;

/** Global variable that a player's script sets. */
interface PlayerGlobal {
  readonly FarolPlayer: { readonly ready: Promise<void> };
}

/**
 * Loads the player with particles, which is beside this one, to show the scene of the URL.
 * @returns fulfilled when that player is ready
 */
export function playWithParticles(): Promise<void> {
  const script = document.createElement('script');
  const url = new URL(ownScript?.src ?? document.baseURI);
  url.pathname = url.pathname.replace(/[^/]*$/, 'farol-player-particles.js');
  script.src = url.href;
  document.body.append(script);
  return new Promise((resolve, reject) => {
    script.addEventListener('load', () => resolve((globalThis as unknown as PlayerGlobal).FarolPlayer.ready));
    script.addEventListener('error', () =>
      reject(new Error(`The player ${script.src} could not be read: reload the page.`)),
    );
  });
}
