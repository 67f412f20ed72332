/** Headsets: sessions of WebXR that show a scene, fetched where `navigator.xr` is there. */
export { addXRButtons } from './addXRButtons';
export { stageOf } from './stageOf';
export { playInXR, type XRMode, xrModes, type XRStage } from './playInXR';
