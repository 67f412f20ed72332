/** The element that the player came by: known only while it runs first. */
const ownScript = document.currentScript as HTMLScriptElement | null;

/** What a player's script leaves on its page. */
interface PlayerGlobal {
  readonly FarolPlayer: { readonly ready: Promise<void> };
}

/**
 * Has the player with particles, which lies beside this one, show the scene of the address.
 * @returns fulfilled when that player is ready
 */
export function playWithParticles(): Promise<void> {
  const script = document.createElement('script');
  const url = new URL(ownScript?.src ?? document.baseURI);
  url.pathname = url.pathname.replace(/[^/]*$/, 'farol-player-particles.js');
  script.src = url.href;
  Object.assign(script.dataset, ownScript?.dataset);
  document.body.append(script);
  return new Promise((resolve, reject) => {
    script.addEventListener('load', () => resolve((globalThis as unknown as PlayerGlobal).FarolPlayer.ready));
    script.addEventListener('error', () => reject(new Error(`The player could not be read: ${script.src}`)));
  });
}
