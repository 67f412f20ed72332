import { Vector2, Vector4 } from 'three';
import type { LightBufferUniforms } from '../../frame/LightBuffer';
import type { ThinGBufferUniforms } from '../../frame/ThinGBuffer';
import { unprojectUniforms } from '../../gpu/unprojectUniforms';

export function thinGBufferUniforms(): ThinGBufferUniforms {
  return {
    ...unprojectUniforms(),
    farol_thinSurface: { value: null },
    farol_thinDepth: { value: null },
    farol_thinStored: { value: 0 },
    farol_size: { value: new Vector2() },
    farol_fit: { value: new Vector4() },
  };
}

export function lightBufferUniforms(): LightBufferUniforms {
  return {
    ...thinGBufferUniforms(),
    farol_sums0: { value: null },
    farol_sums1: { value: null },
    farol_sums2: { value: null },
    farol_sums3: { value: null },
    farol_lightGrid: { value: new Vector4() },
  };
}
