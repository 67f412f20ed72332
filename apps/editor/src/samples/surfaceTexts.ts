export { default as dissolveText } from '../model/surfaces/dissolve.surface?raw';
export { default as hologramText } from '../model/surfaces/hologram.surface?raw';
export { default as rustText } from '../model/surfaces/rust.surface?raw';
export { default as wavesText } from '../model/surfaces/waves.surface?raw';
