/**
 * Main entry, for authors of games and pages. Declarations of fields, files, prefabs and builders of meshes have
 * entries of their own: `@farol/engine/fields`, `/files`, `/prefabs`, `/builders`; demo scenes are `@farol/scenes`.
 */
export { App, type AppOptions, type FrameInfo } from './app/App';
export { createWebGLRenderer, noWebGL2 } from './app/createWebGLRenderer';
export { followEffects } from './picture/followEffects';
export { effectFields } from './settings/effectFields';
export { techniqueAbilities, type TechniqueAbilities } from './picture/techniqueAbilities';
export { PictureRenderer, type PictureRendererOptions, type ScenePainter } from './picture/PictureRenderer';
export { InputRouter, type InputSink, type InputSurface } from './app/InputRouter';
export { TouchControls } from './app/TouchControls';
export { watchPixelRatio } from './app/watchPixelRatio';
export { MicroShaderOverrides, type MicroShaderProblem } from './app/MicroShaderOverrides';

export { Component } from './core/Component';
export { createRandom } from './base/createRandom';
export type { EngineKeyEvent, EnginePointerEvent } from './core/events';
export { GameObject } from './core/GameObject';
export { gameObjectOf } from './core/gameObjectOf';
export { hitPoint, type MeshCaster, rayHits } from './core/rayHits';
export type { RequiredEffect } from './core/RequiredEffect';
export { Scene } from './core/Scene';
export type { SceneOptions } from './core/SceneOptions';
export type { CameraComponent } from './core/CameraComponent';
export type { ComponentClass } from './core/ComponentClass';
export type { AddComponentOptions } from './core/GameObject';
export type { NewObject } from './core/NewObject';
export type { SceneChange } from './core/SceneChange';
export type { SceneSystem, SceneSystemClass } from './core/SceneSystem';
export type { CostlyEvents, ObjectPointerEvent } from './core/events';
export type { MoveOptions } from './core/moveGameObject';
export type { SceneMicroShaders } from './core/SceneMicroShaders';
export type { ScenePicture } from './core/ScenePicture';
export type { SceneView, SceneViews } from './core/SceneViews';
export type { SceneSettings } from './settings/SceneSettings';
export type { Vector3Input } from './core/toVector3';

export { ComponentRegistry, type ComponentRegistryOptions } from './core/ComponentRegistry';
export { builtinComponents } from './components/index';
export { Animation, type PlayOptions } from './components/Animation';
export { Animator } from './components/Animator';
export { AudioListener } from './components/AudioListener';
export { AudioSource } from './components/AudioSource';
export { audioOutput, type AudioOutput } from './audio/audioOutput';
export { Camera } from './components/Camera';
export { CharacterController } from './components/CharacterController';
export { Collider } from './components/Collider';
export { Joint } from './components/Joint';
export { Decal } from './components/Decal';
export { FogVolume } from './components/FogVolume';
export { EventTrigger } from './components/EventTrigger';
export { Grabbable } from './components/Grabbable';
export { KeyController } from './components/KeyController';
export { Light } from './components/Light';
export { LightGroup } from './components/LightGroup';
export { soloLights } from './components/lightGroups';
export { lightShadows, meshShadows, sunShadows } from './components/newShadows';
export { ModelRenderer } from './components/ModelRenderer';
export { morphField } from './components/MorphTargets';
export { MouseController } from './components/MouseController';
export { ObjectRenderer } from './components/ObjectRenderer';
export { ParticleEmitter } from './components/ParticleEmitter';
export { particlePreset } from './components/particleCode';
export { RandomMovement } from './components/RandomMovement';
export { shapeOf, type ShapeSource } from './core/ShapeSource';
export { Room } from './components/Room';
export { Wall } from './components/Wall';
export { XRRig } from './components/XRRig';
export { SunAndMoon } from './components/SunAndMoon';
export { RigidBody } from './components/RigidBody';
export type { CollisionEvent } from './physics/CollisionEvent';
export { PhysicsSystem } from './physics/PhysicsSystem';
export { Transform } from './core/Transform';

export { objectsByName, targetOfTrack } from './animation/bindClip';
export type { ClipData, ClipEvent, ClipKey, ClipTrack, Easing } from './assets/clips/ClipData';
export { ClipPreview } from './animation/ClipPreview';
export { clipText } from './assets/clips/clipText';
export { cubicBezier } from './animation/cubicBezier';
export { modelBelow, modelsBelow, type ModelInScene } from './animation/modelsBelow';
export type { NodeProperty } from './animation/Channel';
export type { ClipWrap } from './animation/clipEvents';
export { ClipError, parseClip } from './assets/clips/parseClip';
export { objectAtPath, pathBelow, trackTarget, type TrackTarget } from './animation/trackTarget';
export { valueAt } from './animation/valueAt';

export type { Asset, AssetChange, AssetFile, MaterialUser, TakenAsset } from './assets/Asset';
export { AssetError } from './assets/AssetError';
export { AssetLibrary, type AssetLibraryOptions } from './assets/AssetLibrary';
export { importModel } from './components/importModel';
export {
  type ObjectsOfModel,
  type UnpackOptions,
  objectOfPart,
  objectsOfModel,
  whatKeepsTogether,
} from './components/objectsOfModel';
export { isUnpackable, type KeptPart, keptTogether } from './components/keptTogether';
export { isOfSubtree, type ModelSubtree, partsText, subtreeOf } from './assets/modelNodes';
export { ClipAsset } from './assets/clips/ClipAsset';
export { FieldAsset, type FieldAssetHost, type FieldAssetType } from './assets/FieldAsset';
export { MaterialAsset } from './assets/MaterialAsset';
export { ScriptAsset } from './assets/ScriptAsset';
export { sourceOfMaterial } from './assets/derivedMaterial';
export { SurfaceAsset } from './assets/SurfaceAsset';
export { Sound } from './assets/Sound';
export type { FetchBytes, FetchOptions } from './assets/loadAsset';
export { addMeshPack, type MeshPack } from './assets/meshPacks';
export { Model, ModelClip } from './assets/Model';
