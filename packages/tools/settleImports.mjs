import { afterAll, vi } from 'vitest';

// a module that is still being fetched when a file of tests ends would fail, and be broken for all files after it
afterAll(() => vi.dynamicImportSettled());
