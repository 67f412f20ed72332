import { beforeLastBrace } from '../three/beforeLastBrace';

/** Last but one of WebGL 2's 16 vertex attribute locations (objectAttribute.ts has the last); three's materials need fewer. */
const LOCATION = 14;

const DECLARATION = `layout(location = ${LOCATION}) in highp vec2 farol_layersAttribute;\nflat out highp vec2 farol_objectLayers;\n`;

/** Adds `farol_objectLayers` to a vertex shader: constant over a draw, set by `setLayers`. */
export function withLayers(vertexShader: string): string {
  return `${DECLARATION}${beforeLastBrace(vertexShader, 'farol_objectLayers = farol_layersAttribute;')}`;
}

/** Sets the layers for the draws that follow, as two numbers of 16 bits. */
export function setLayers(gl: WebGL2RenderingContext, mask: number): void {
  gl.vertexAttrib2f(LOCATION, mask & 0xffff, mask >>> 16);
}

/** Resets the attribute to WebGL's initial value. */
export function resetLayers(gl: WebGL2RenderingContext): void {
  gl.vertexAttrib4f(LOCATION, 0, 0, 0, 1);
}
