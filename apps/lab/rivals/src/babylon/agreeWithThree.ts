import { ShaderStore } from '@babylonjs/core/Engines/shaderStore.js';
import '@babylonjs/core/Shaders/ShadersInclude/pbrDirectLightingFalloffFunctions.js';

/**
 * Replaces formulas in Babylon's store of shader includes that differ from three's, with the same work per light.
 * @throws Error when an include differs from that of Babylon.js 9.34
 */
export function agreeWithThree(): void {
  const store = ShaderStore.IncludesShadersStore;
  const replace = (name: string, from: string, to: string): void => {
    if (store[name].includes(to)) return;
    if (!store[name].includes(from)) throw new Error(`Babylon.js’s shader part ${name} has changed: update this file.`);
    store[name] = store[name].replace(from, to);
  };
  const name = 'pbrDirectLightingFalloffFunctions';
  // three clamps distances to at least 0.1 m
  replace(
    name,
    'float lightDistanceFalloff=1.0/maxEps(lightDistanceSquared);float factor',
    'float lightDistanceFalloff=1.0/max(lightDistanceSquared,0.01);float factor',
  );
  // three fades a spot light's edge by a smoothstep
  replace(name, 'falloff*=falloff;return falloff;}', 'falloff*=falloff*(3.0-2.0*falloff);return falloff;}');
}
