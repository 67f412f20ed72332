export * from './fields/Field';
export * from './fields/fields';
export { checkFieldValue, describeField } from './fields/checkFieldValue';
export { component } from './fields/component';
export { fieldTypeOf, registerFieldType, type FieldType } from './fields/fieldTypes';
export { FieldError } from './fields/FieldError';
export { FieldOwner, sameValue } from './fields/FieldOwner';
export { isFieldVisible } from './fields/isFieldVisible';

export { cancellable } from './core/cancellable';
export { Component, type ComponentClass } from './core/Component';
export { createId } from './core/createId';
export { createRandom } from './core/createRandom';
export type { EngineKeyEvent, EnginePointerEvent } from './core/events';
export { type AddComponentOptions, GameObject } from './core/GameObject';
export { gameObjectOf } from './core/gameObjectOf';
export type { MoveOptions } from './core/moveGameObject';
export { Scene, type SceneOptions } from './core/Scene';
export type { SceneChange } from './core/SceneChange';
export { SceneMicroShaders } from './core/SceneMicroShaders';
export { SceneSettings } from './core/SceneSettings';
export type { Vector3Input } from './core/toVector3';

export { ComponentRegistry } from './components/ComponentRegistry';
export { builtinComponents, componentTypes, createComponent } from './components/builtinComponents';
export { Camera } from './components/Camera';
export { Decal } from './components/Decal';
export { KeyController } from './components/KeyController';
export { Light } from './components/Light';
export { ModelRenderer } from './components/ModelRenderer';
export { MouseController } from './components/MouseController';
export { ObjectRenderer } from './components/ObjectRenderer';
export { RandomMovement } from './components/RandomMovement';
export { Transform } from './components/Transform';

export { type Asset, type AssetChange } from './assets/Asset';
export { type AssetFile, type TakenAsset } from './assets/Asset';
export { AssetError } from './assets/AssetError';
export { AssetLibrary, type AssetLibraryOptions } from './assets/AssetLibrary';
export { AddressRefusedError, foreignOrigin } from './assets/foreignOrigin';
export { type FetchBytes, type FetchOptions, readableEndings, typeOfUrl } from './assets/loadAsset';
export { makeKTX2Loader } from './assets/makeKTX2Loader';
export { Model } from './assets/Model';
export { checkModel } from './assets/checkModel';
export { decodedUri, packGltf } from './assets/packGltf';
export { checkModelFile, modelError } from './assets/readModel';
export { type GltfJson, readGltfJson } from './assets/readGltfJson';
export { computeCreaseNormals } from './geometry/computeCreaseNormals';
export { MeshBuilder } from './geometry/MeshBuilder';
export { parsePly } from './geometry/parsePly';

export {
  defineScene,
  type SceneBuildOptions,
  type SceneDefinition,
  type SceneParameters,
} from './scenes/SceneDefinition';
export { fetchLateCode } from './fetchLateCode';
export { collectFiles, type FileMap } from './assets/collectFiles';
export { scenes } from './scenes/index';
export { benchmarkLights } from './scenes/benchmark/benchmarkLights';
export { benchmarkLightsObjects } from './scenes/benchmark/benchmarkLightsObjects';
export { dragons, type DragonsOptions } from './scenes/dragon/dragons';
export { niceScene, type NiceSceneOptions } from './scenes/dragon/niceScene';
export { sponza, type SponzaOptions } from './scenes/sponza/sponza';
export { temple } from './scenes/temple/temple';
export { importModel } from './assets/importModel';

export { planApplyAll, planApplyField, planRevertAll, planUnpack, withoutPin } from './prefabs/applyOverrides';
export { instanceRootOf, isInstanceRoot, keyOf as componentKeyOf } from './prefabs/instances';
export { instantiatePrefab } from './prefabs/instantiatePrefab';
export { type MadePrefab, makePrefab } from './prefabs/makePrefab';
export { type FieldOverride, fieldOverride, overridesOf, type PrefabOverrides } from './prefabs/overrides';
export { changePrefab, planPrefabChange, type PrefabPlan } from './prefabs/planPrefabChange';
export { type Prefab, PrefabError, type PrefabLink } from './prefabs/Prefab';
export { applyPrefabEdit, type PrefabEdit } from './prefabs/PrefabEdit';
export type { PrefabTable } from './prefabs/PrefabTable';

export { assetUses, type AssetUse } from './file/assetUses';
export { type ContainerContent, containerContent, inlineAssets, writeContainer } from './file/container';
export { deserialize, type DeserializeOptions, type MayFetch } from './file/deserialize';
export { FILE_VERSION, type FarolFile, type FileAsset, type FileComponent, type FileObject } from './file/FarolFile';
export { FileError, type FileErrorOptions, type FileProblem } from './file/FileError';
export { fileLimits } from './file/fileLimits';
export { type ForeignAddress, foreignAddresses } from './file/foreignAddresses';
export { makeObjects } from './file/makeObjects';
export { parseFile, type ParseOptions } from './file/parseFile';
export { readSceneFile, type SceneFile } from './file/readSceneFile';
export { type MayUnpack, sizesText, unpack, unpackLimits, type UnpackQuestion } from './file/unpack';
export { serialize, serializeHead, serializeObject, type SerializeOptions } from './file/serialize';

export { MicroShaderOverrides, type MicroShaderProblem } from './app/MicroShaderOverrides';
export { App, type AppOptions, type FrameInfo } from './app/App';
export { createWebGLRenderer, noWebGL2 } from './app/createWebGLRenderer';
export { followDecals } from './app/followDecals';
export { InputRouter, type InputSink, type InputSurface } from './app/InputRouter';
