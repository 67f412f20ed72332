import type { Stage } from './Stage';

// The frame's realm offers its competitors to the page: see Stage.ts.
const stage: Partial<Stage> = {};
window.stage = stage as Stage;
