/** Whether this player contains the renderer's particles; false in the build for scenes without particles. */
export const hasParticles: boolean = true;
