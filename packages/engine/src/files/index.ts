/** Scene files, their containers, and the files that assets are read from. */
export { assetUses, type AssetUse } from './assetUses';
export { type ContainerContent, containerContent, inlineAssets, writeContainer } from './container';
export { deserialize, type DeserializeOptions, type MayFetch } from './deserialize';
export { FILE_VERSION, type FarolFile, type FileAsset, type FileComponent, type FileObject } from './FarolFile';
export { FileError, type FileErrorOptions, type FileProblem } from './FileError';
export { fileLimits } from './fileLimits';
export { type ForeignAddress, foreignAddresses } from './foreignAddresses';
export { makeObjects } from './makeObjects';
export { parseFile, type ParseOptions } from './parseFile';
export { preloadFileCode } from './preloadFileCode';
export { restoreComponent } from './restoreComponent';
export { readSceneFile, type SceneFile } from './readSceneFile';
export { serialize, serializeHead, serializeObject, type SerializeOptions } from './serialize';
export { type MayUnpack, sizesText, unpack, unpackLimits, type UnpackQuestion } from './unpack';

export type { ComponentData } from '../core/SceneGraph';
export { makeUnknownComponent, UnknownComponent } from '../core/UnknownComponent';
export { cancellable } from '../core/cancellable';
export { createId } from '../core/createId';
export { checkModel } from '../assets/checkModel';
export { collectFiles, type FileMap } from '../assets/collectFiles';
export { AddressRefusedError, foreignOrigin } from '../assets/foreignOrigin';
export { readableEndings, typeOfUrl } from '../assets/loadAsset';
export { makeKTX2Loader } from '../assets/makeKTX2Loader';
export { decodedUri, packGltf } from './packGltf';
export { type GltfJson, readGltfJson } from '../assets/readGltfJson';
export { checkModelFile, modelError } from '../assets/readModel';
