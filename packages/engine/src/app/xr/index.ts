/** WebXR sessions that show a scene; fetched where `navigator.xr` exists. */
export { addXRButtons } from './addXRButtons';
export { stageOf } from './stageOf';
export { playInXR, type XRMode, xrModes, type XRStage } from './playInXR';
