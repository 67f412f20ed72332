import type { Material } from 'three';
import { flagsOf, shadingModelOf, type ShadingModel } from './shadingModel';
import { litTwin } from '../materials/litTwin';
import type { TwinKind } from '../materials/TwinKind';

export const OUTPUTS =
  'layout(location = 1) out highp vec4 farol_outNormal;\nlayout(location = 2) out highp vec4 farol_outAlbedo;\nlayout(location = 3) out highp vec4 farol_outMaterial;\n';

type AnyMaterial = Material & {
  isMeshToonMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
  isMeshStandardMaterial?: boolean;
};

/** For the views of the G-buffer, what the G-buffer itself would not take is written too, by the nearest model. */
export function nearestModel(source: Material): ShadingModel {
  const m = source as AnyMaterial;
  return (
    shadingModelOf(source) ?? (m.isMeshStandardMaterial ? 'standard' : m.isMeshPhongMaterial ? 'phong' : 'lambert')
  );
}

export const outputs = (text: string, source: Material) =>
  `${OUTPUTS}#define FAROL_FLAGS ${flagsOf(source, nearestModel(source))}.0\n${text}`;

/** Writes the G-buffer; the first attachment gets emissive, ambient, environment and what three itself lights. */
export const gbufferTwin: TwinKind = litTwin({
  key: 'gbuffer',
  loop: 'lightLoopNone',
  chunks: ['gbufferWrite'],
  properties: { fog: false },
  variant: (source) => String(flagsOf(source, nearestModel(source))),
  rewrite: outputs,
  atEnd: 'FAROL_WRITE_GBUFFER',
});
