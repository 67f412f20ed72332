// Code for opening scenes, and pages beside the editor, fetched after the first frame. Named from here and not by its package,
// whose index would bring it to the first frame.
export { deserialize, openBeside, readSceneFile, sizesText } from '@farol/engine/files';
export { seenFile } from './seenFile';
