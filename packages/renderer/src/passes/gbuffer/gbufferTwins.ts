import type { Material } from 'three';
import { attachmentOutputs } from '../../gbuffer/gbufferNames';
import { flagsOf, shadingModelOf } from '../../gbuffer/shadingModel';
import type { ShadingModel } from '../../gbuffer/surfaceFlags';
import { litTwin } from '../../materials/litTwin';
import type { TwinKind } from '../../materials/TwinKind';

/** Declarations of the outputs of G-buffer shaders besides gl_FragColor. */
export const OUTPUTS = attachmentOutputs();

type AnyMaterial = Material & {
  isMeshToonMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
  isMeshStandardMaterial?: boolean;
};

/** Shading model of a material, or the nearest one for materials that only views draw to a G-buffer. */
export function nearestModel(source: Material): ShadingModel {
  const m = source as AnyMaterial;
  return (
    shadingModelOf(source) ?? (m.isMeshStandardMaterial ? 'standard' : m.isMeshPhongMaterial ? 'phong' : 'lambert')
  );
}

export const outputs = (text: string, source: Material) =>
  `${OUTPUTS}#define FAROL_FLAGS ${flagsOf(source, nearestModel(source))}\n${text}`;

/**
 * Twin that writes the G-buffer; the first attachment receives emissive, ambient and environment light, and that of lights left
 * to three.
 */
export const gbufferTwin: TwinKind = litTwin({
  key: 'gbuffer',
  role: 'gbuffer',
  loop: 'lightLoopNone',
  chunks: ['gbufferWrite'],
  properties: { fog: false, dithering: false },
  variant: (source) => String(flagsOf(source, nearestModel(source))),
  rewrite: outputs,
  atEnd: 'FAROL_WRITE_GBUFFER',
});
