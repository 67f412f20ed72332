// Code for opening scenes, and pages beside the editor, fetched after the first frame. Exported by this file, since an
// import of the package's index would load it before the first frame.
export { deserialize, openBeside, readSceneFile, sizesText } from '@farol/engine/files';
export { seenFile } from './seenFile';
