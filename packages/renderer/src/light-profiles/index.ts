export { IESLoader } from './IESLoader';
export { IESError } from './IESError';
export { type IESOptions, parseIES, tiltFileOf } from './parseIES';
export { PhotometricProfile } from './PhotometricProfile';
export type { IESVersion, LampTilt, PhotometricData } from './PhotometricData';
export { writeIES } from './writeIES';
