// The microshaders of this folder, by name.
export { default as ambientLight } from './ambientLight.glsl?raw';
export { default as globalLightsFragment } from './globalLightsFragment.glsl?raw';
export { default as incidentLight } from './incidentLight.glsl?raw';
export { default as lightAttenuation } from './lightAttenuation.glsl?raw';
export { default as lightMask } from './lightMask.glsl?raw';
export { default as lightRecord } from './lightRecord.glsl?raw';
export { default as lightTable } from './lightTable.glsl?raw';
