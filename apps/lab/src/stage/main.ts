import { LabStage } from './LabStage';

// interface for the page that holds this frame: see Stage.ts
window.stage = new LabStage();
