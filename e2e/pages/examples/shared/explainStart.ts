import { noWebGL2 } from '@farol/engine';

/** Explains an example's failed start without WebGL 2. Runs before the example. */
function explain(): void {
  if (document.querySelector('[role=alert]') || document.createElement('canvas').getContext('webgl2')) return;
  const words = document.createElement('main');
  words.setAttribute('role', 'alert');
  words.textContent = `The example cannot start. ${noWebGL2}`;
  document.body.append(words);
}

addEventListener('error', explain);
addEventListener('unhandledrejection', explain);
