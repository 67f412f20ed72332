/** Late code of picture effects, fetched for the first scene that uses one. */
export { PictureChain } from './PictureChain';
export { surroundings } from './surroundings';
