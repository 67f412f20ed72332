import { BackSide, DoubleSide, FrontSide, type Material } from 'three';
import { hasNodes } from './hasNodes';
import { replaceOnce } from './replaceOnce';
import type { TwinKind, TwinShader } from './TwinKind';

const AFTER_TESTS = '#include <alphahash_fragment>';

/** Depth alone: three's own vertex stage, and of the fragment stage what may discard. */
export const depthTwin: TwinKind = {
  key: 'depth',
  chunks: () => [],
  properties: { colorWrite: false },
  patch(shader: TwinShader, source: Material) {
    shader.fragmentShader = replaceOnce(
      shader.fragmentShader,
      AFTER_TESTS,
      `${AFTER_TESTS}\ngl_FragColor = vec4(0.0);\nif (true) return;`,
      `the fragment shader of material "${source.name || source.type}"`,
    );
  },
};

/** The same, some rounding steps farther, so that what is then drawn at these depths is not hidden by them. */
export const depthBehindTwin: TwinKind = {
  ...depthTwin,
  properties: { colorWrite: false, polygonOffset: true, polygonOffsetFactor: 0, polygonOffsetUnits: 4 },
};

/**
 * True for materials of which the depth twin can be made. Units of an offset are not the same in depth of 24 bits and of
 * floats: what is pushed back by more than one has none.
 */
export function hasDepthTwin(material: Material): boolean {
  const m = material as Material & { isShaderMaterial?: boolean };
  if (m.polygonOffset && m.polygonOffsetUnits > 1) return false;
  return m.isShaderMaterial !== true && !hasNodes(m) && [FrontSide, BackSide, DoubleSide].includes(m.side as never);
}
