import { transformScript } from '@farol/engine/scripts/transform';

(globalThis as unknown as { farolCompile: typeof transformScript }).farolCompile = transformScript;
