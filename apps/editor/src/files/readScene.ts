// What opening a scene needs: fetched by itself, after the first frame.
export { deserialize, readSceneFile } from '@farol/engine/files';
export { seenFile } from './seenFile';
