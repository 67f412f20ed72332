import { beforeLastBrace } from '../../three/beforeLastBrace';
import type { TwinKind } from '../../materials/TwinKind';

/** Location of the last of the 16 vertex attributes that WebGL 2 guarantees; three's own materials need fewer. */
const LOCATION = 15;

const DECLARATION = `layout(location = ${LOCATION}) in highp vec2 farol_objectAttribute;\nvarying highp vec2 farol_object;\n`;

/** Vertex shader code that gives each instance its own object number. */
const NUMBER = `farol_object = farol_objectAttribute;
#if defined( USE_BATCHING )
  farol_object.x = mod(farol_object.x + 89.0 * float(getIndirectIndex(gl_DrawID)), 2047.0) + 1.0;
#elif defined( USE_INSTANCING )
  farol_object.x = mod(farol_object.x + 89.0 * float(gl_InstanceID), 2047.0) + 1.0;
#endif
`;

/**
 * Twin kind whose shader also gets the object number, one for each instance, as the varying `farol_object`. `setObject` sets it
 * before each draw as a constant vertex attribute, which needs no change of material.
 */
export function withObject(kind: TwinKind): TwinKind {
  return {
    ...kind,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      shader.vertexShader = `${DECLARATION}${beforeLastBrace(shader.vertexShader, NUMBER)}`;
    },
  };
}

/**
 * Sets `farol_object` for the draws that follow.
 * @param number - from `objectNumber`
 * @param corner - from `stippleCorner`; 0 for opaque objects
 */
export function setObject(gl: WebGL2RenderingContext, number: number, corner: number): void {
  gl.vertexAttrib2f(LOCATION, number, corner);
}

/** Resets the attribute to WebGL's initial value. */
export function resetObject(gl: WebGL2RenderingContext): void {
  gl.vertexAttrib4f(LOCATION, 0, 0, 0, 1);
}
