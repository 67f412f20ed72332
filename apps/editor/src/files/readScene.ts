// Code for opening scenes, fetched after the first frame.
export { deserialize, readSceneFile } from '@farol/engine/files';
export { seenFile } from './seenFile';
