/** Why the browser cannot draw with WebGL 2, and what helps, as a sentence; null when it can. */
export function webglProblem(): string | null {
  if (typeof WebGL2RenderingContext === 'undefined') {
    return 'This browser has no WebGL 2: use Chrome, Edge or Firefox of the last two years, or Safari 17 or newer.';
  }
  if (!document.createElement('canvas').getContext('webgl2')) {
    return 'WebGL 2 is switched off here: switch hardware acceleration on in the browser’s settings, or update the graphics driver, then load the page again.';
  }
  return null;
}
