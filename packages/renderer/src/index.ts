export { FarolRenderer, type FarolEvents } from './FarolRenderer';
export type { FarolOptions } from './FarolOptions';
export { techniques, type TechniqueName } from './techniques';
export { views, type View } from './frame/views';
export type { FarolEffect } from './frame/FarolEffect';
export type { FarolInfo, PassInfo } from './frame/FarolInfo';
export type { LazyPart } from './frame/lazyCode';
export { setShading } from './materials/setShading';
export type { ShadingName } from './materials/shadingOf';
