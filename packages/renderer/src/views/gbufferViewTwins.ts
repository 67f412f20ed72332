import { flagsOf } from '../gbuffer/shadingModel';
import { nearestModel, OUTPUTS, outputs } from '../passes/gbuffer/gbufferTwins';
import { litTwin } from '../materials/litTwin';
import type { TwinKind, TwinShader } from '../materials/TwinKind';

/** Twin like `gbufferTwin`, but the first attachment holds only emissive light. */
export const litViewTwin: TwinKind = litTwin({
  key: 'gbuffer-view',
  loop: 'lightLoopNone',
  chunks: ['gbufferWrite'],
  properties: { fog: false },
  variant: (source) => String(flagsOf(source, nearestModel(source))),
  rewrite: outputs,
  atEnd: 'FAROL_WRITE_GBUFFER\ngl_FragColor.rgb = totalEmissiveRadiance;',
});

/** Twin of MeshBasicMaterial in the views: its colour counts as emissive. */
export const unlitViewTwin: TwinKind = {
  key: 'gbuffer-unlit',
  chunks: () => [],
  properties: { fog: false },
  patch(shader: TwinShader) {
    const at = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `${OUTPUTS}${shader.fragmentShader.slice(0, at)}
farol_outNormal = vec4(0.0); farol_outAlbedo = vec4(0.0, 0.0, 0.0, 32.0 / 255.0); farol_outMaterial = vec4(0.0);
}`;
  },
};
