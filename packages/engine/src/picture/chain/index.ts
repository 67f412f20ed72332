/** What a scene's picture needs that not every scene has: fetched when the first does. */
export { PictureChain } from './PictureChain';
export { surroundings } from './surroundings';
