import { beforeLastBrace } from '../../three/beforeLastBrace';
import { overdrawTwin } from '../../materials/overdrawTwin';
import type { TwinKind } from '../../materials/TwinKind';

const OUTPUTS = 'layout(location = 1) out highp vec4 farol_out1;\nlayout(location = 2) out highp vec4 farol_out2;\n';

/** Adds one to the first attachment of the light buffer where the thin G-buffer would have been written. */
export const lightBufferCountTwin: TwinKind = {
  ...overdrawTwin,
  key: 'light-buffer-count',
  patch(shader, source, header) {
    overdrawTwin.patch(shader, source, header);
    shader.fragmentShader = `${OUTPUTS}${beforeLastBrace(shader.fragmentShader, 'farol_out1 = farol_out2 = vec4(0.0);')}`;
  },
};
