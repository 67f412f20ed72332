import type { RecentFile } from '../../model/RecentFiles';
import { keyedStore } from '../keyedStore';

const store = keyedStore<RecentFile>('farol-recent');

/** All recent files, newest first. */
export const readRecent = async (): Promise<RecentFile[]> => (await store.all()).toSorted((a, b) => b.time - a.time);

export const writeRecent = (file: RecentFile): Promise<unknown> => store.put(file);

export const deleteRecent = (id: string): Promise<unknown> => store.delete(id);
