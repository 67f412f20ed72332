export { attachEditor, type AttachOptions } from './attachEditor';
export type { AttachedEditor } from './AttachedEditor';
export type { Drawer } from './model/Drawing';
export type { Edit, History } from './model/History';
