/** Whether the text of a scene file has particles. */
export const needsParticles = (text: string): boolean => text.includes('"ParticleEmitter"');
