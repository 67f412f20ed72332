// The microshaders of this folder, by name.
export { default as lightVolumeCone } from './lightVolumeCone.glsl?raw';
export { default as lightVolumeFragment } from './lightVolumeFragment.glsl?raw';
export { default as lightVolumeSphere } from './lightVolumeSphere.glsl?raw';
export { default as lightVolumeWide } from './lightVolumeWide.glsl?raw';
export { default as volumeLighting } from './volumeLighting.glsl?raw';
