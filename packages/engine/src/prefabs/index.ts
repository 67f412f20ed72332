/** Prefabs (trees of objects placed any number of times), and operations on them for editors. */
export { planApplyAll, planApplyField, planRevertAll, planUnpack, withoutPin } from './applyOverrides';
export { instanceRootOf, isInstanceRoot } from './instances';
export { instantiatePrefab } from './instantiatePrefab';
export { type MadePrefab, makePrefab } from './makePrefab';
export { type FieldOverride, fieldOverride, overridesOf, type PrefabOverrides } from './overrides';
export { changePrefab, planPrefabChange, type PrefabPlan } from './planPrefabChange';
export { type Prefab, PrefabError, type PrefabLink } from '../core/Prefab';
export { applyPrefabEdit, type PrefabEdit } from './PrefabEdit';
export type { PrefabTable } from '../core/PrefabTable';
