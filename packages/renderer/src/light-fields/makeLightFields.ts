import type { Frame } from '../frame/Frame';
import { lacksFloatTargets } from '../gpu/checkDevice';
import { addMicroShaders } from '../microshaders/addMicroShaders';
import * as chunks from './chunks';
import { fieldSlices, type FieldSlices } from './FieldSlices';
import { LightFields } from './LightFields';

/** GLSL texts of the microshaders of light fields, by name. */
export const microShaders = { ...chunks };

const reported = new WeakSet<object>();

/** Makes the draws of light fields; null, with one warning, if the device draws to no float targets. */
export function makeLightFields(frame: Frame): LightFields | null {
  const { webgl, microshaders } = frame;
  const gl = webgl.getContext();
  if (gl.getExtension('EXT_color_buffer_float') === null) {
    if (frame.lights.fields.length > 0 && !reported.has(gl) && !gl.isContextLost()) {
      reported.add(gl);
      console.warn(
        `Farol: this device ${lacksFloatTargets(webgl) ?? 'draws only to half floats'}, so LightFields give no light; use three's lights.`,
      );
    }
    return null;
  }
  addMicroShaders(microshaders, 'light-fields', microShaders);
  const uniforms = frame.uniforms as typeof frame.uniforms & Partial<FieldSlices>;
  // added to the shared uniforms, for twins made later
  if (uniforms.farol_fieldSlices === undefined) Object.assign(uniforms, fieldSlices());
  return new LightFields(frame, uniforms as FieldSlices);
}
