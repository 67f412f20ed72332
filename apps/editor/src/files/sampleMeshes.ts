export { registerSceneAssets } from '@farol/scenes';
