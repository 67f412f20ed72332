import { BackSide, DoubleSide, FrontSide, type Material } from 'three';
import { hasNodes } from '../three/hasNodes';
import { afterChunkOrAtEnd } from '../three/replaceChunk';
import type { TwinKind, TwinShader } from './TwinKind';

/** Twin that writes only depth, by three's vertex shader and those parts of the fragment shader that may discard. */
export const depthTwin: TwinKind = {
  key: 'depth',
  chunks: () => [],
  properties: { colorWrite: false },
  patch(shader: TwinShader) {
    const nothing = 'gl_FragColor = vec4(0.0);\nif (true) return;';
    shader.fragmentShader = afterChunkOrAtEnd(shader.fragmentShader, 'alphahash_fragment', nothing);
  },
};

/** Depth twin offset backwards by some rounding steps, so that a later draw at equal depth is not hidden. */
export const depthBehindTwin: TwinKind = {
  ...depthTwin,
  properties: { colorWrite: false, polygonOffset: true, polygonOffsetFactor: 0, polygonOffsetUnits: 4 },
};

/**
 * True for materials for which the depth twin works. False for polygon offsets of more than one unit, which differ between
 * 24-bit and float depth.
 */
export function hasDepthTwin(material: Material): boolean {
  return !(material.polygonOffset && material.polygonOffsetUnits > 1) && hasDistanceTwin(material);
}

/** Whether a twin can write depth, or distance, in the material's shader. */
export function hasDistanceTwin(material: Material): boolean {
  const m = material as Material & { isShaderMaterial?: boolean };
  const { side } = m;
  return (
    m.isShaderMaterial !== true && !hasNodes(m) && (side === FrontSide || side === BackSide || side === DoubleSide)
  );
}
