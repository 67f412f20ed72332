/** The element that the player came by: known only while it runs first. */
const ownScript = document.currentScript as HTMLScriptElement | null;

/** Has the player with particles, which lies beside this one, show the scene of the address. */
export function playWithParticles(): void {
  const script = document.createElement('script');
  const url = new URL(ownScript?.src ?? document.baseURI);
  url.pathname = url.pathname.replace(/[^/]*$/, 'farol-player-particles.js');
  script.src = url.href;
  Object.assign(script.dataset, ownScript?.dataset);
  document.body.append(script);
}
