export { attachEditor } from './attachEditor';
export type { AttachOptions } from './AttachOptions';
export type { AttachedEditor } from './AttachedEditor';
export type { AttachLanguage } from './language/languages';
export type { Drawer } from './model/Drawing';
export type { Command, CommandStack } from '@farol/editing';
