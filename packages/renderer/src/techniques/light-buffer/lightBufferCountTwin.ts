import { beforeLastBrace } from '../../three/beforeLastBrace';
import { overdrawTwin } from '../../materials/overdrawTwin';
import type { TwinKind } from '../../materials/TwinKind';

const OUTPUTS = [1, 2, 3].map((i) => `layout(location = ${i}) out highp vec4 farol_out${i};\n`).join('');

/** Adds one to the first attachment of the light buffer where the thin G-buffer would have been written. */
export const lightBufferCountTwin: TwinKind = {
  ...overdrawTwin,
  key: 'light-buffer-count',
  patch(shader, source, header) {
    overdrawTwin.patch(shader, source, header);
    shader.fragmentShader = `${OUTPUTS}${beforeLastBrace(shader.fragmentShader, 'farol_out1 = farol_out2 = farol_out3 = vec4(0.0);')}`;
  },
};
