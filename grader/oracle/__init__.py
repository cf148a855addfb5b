"""What is right? Meshes, rays and answers that do not come from a submission."""
