import type { Material } from 'three';
import { flagsOf, shadingModelOf, type ShadingModel } from '../gbuffer/shadingModel';
import { litTwin } from './litTwin';
import type { TwinKind, TwinShader } from './TwinKind';

const OUTPUTS =
  'layout(location = 1) out highp vec4 farol_outNormal;\nlayout(location = 2) out highp vec4 farol_outAlbedo;\nlayout(location = 3) out highp vec4 farol_outMaterial;\n';

type AnyMaterial = Material & {
  isMeshToonMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
  isMeshStandardMaterial?: boolean;
};

/** For the views of the G-buffer, what the G-buffer itself would not take is written too, by the nearest model. */
function nearestModel(source: Material): ShadingModel {
  const m = source as AnyMaterial;
  return (
    shadingModelOf(source) ?? (m.isMeshStandardMaterial ? 'standard' : m.isMeshPhongMaterial ? 'phong' : 'lambert')
  );
}

const outputs = (text: string, source: Material) =>
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

/** The same for the views: the first attachment holds emissive alone. */
export const gbufferViewTwin: TwinKind = litTwin({
  key: 'gbuffer-view',
  loop: 'lightLoopNone',
  chunks: ['gbufferWrite'],
  properties: { fog: false },
  variant: (source) => String(flagsOf(source, nearestModel(source))),
  rewrite: outputs,
  atEnd: 'FAROL_WRITE_GBUFFER\ngl_FragColor.rgb = totalEmissiveRadiance;',
});

/** MeshBasicMaterial in the views: its colour is emissive. */
export const gbufferUnlitTwin: TwinKind = {
  key: 'gbuffer-unlit',
  chunks: () => [],
  properties: { fog: false },
  patch(shader: TwinShader) {
    const at = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `${OUTPUTS}${shader.fragmentShader.slice(0, at)}
farol_outNormal = vec4(0.0); farol_outAlbedo = vec4(0.0, 0.0, 0.0, 0.0); farol_outMaterial = vec4(0.0);
}`;
  },
};
