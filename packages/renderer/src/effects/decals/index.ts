export { Decal } from './Decal';
export { Decals } from './Decals';
