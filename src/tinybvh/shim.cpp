// tinybvh behind a C interface: triangles and rays in, hits out. `index.rs` declares the same functions.
//
// tinybvh ends the process where it is misused (BVH_FATAL_ERROR), and its stacks have fixed heights that it does not
// check. So what it does not take is refused here, before it sees it.

#include <cfloat>
#include <cmath>
#include <cstdint>

// From how many triangles on a build of this thread uses several threads: tinybvh's own setting, here a variable.
static thread_local uint32_t threaded_from;
#define MT_BUILD_THRESHOLD threaded_from
#define TINYBVH_IMPLEMENTATION
#include <tiny_bvh.h>

using namespace tinybvh;

#include "threads.h"

namespace {

struct Query { float origin[3], t_min, dir[3], t_max; };      // `math::Ray`
struct Found { float t; uint32_t object, prim; float u, v; }; // `math::Hit`
struct Facts { uint64_t bytes; bool spatial, threaded; };
enum Refusal : uint32_t { NONE, MEMORY, DEEP, LARGE };

// What tinybvh builds threaded from, as it is shipped.
const uint32_t THREADED_FROM = 50000;
// Levels of the binary tree: what fits into the stacks (64 and 128) of SplitLeafs, Compact and the collapse.
const uint32_t LEVELS = 48;
// How far rays go and come from. Where a node has no child, it has a box at 10^30 that no ray may meet.
const float FARTHEST = 1e25f;
// Entries of the stack of a search, of which a node writes eight at once.
const uint32_t STACK = 256;

bool is_too_deep( const BVH& bvh )
{
	std::vector<std::pair<uint32_t, uint32_t>> todo{ { 0, 1 } };
	while (!todo.empty()) {
		const auto [index, level] = todo.back();
		todo.pop_back();
		if (level > LEVELS) return true;
		const BVH::BVHNode& node = bvh.bvhNode[index];
		if (!node.isLeaf()) todo.push_back( { node.leftFirst, level + 1 } ), todo.push_back( { node.leftFirst + 1, level + 1 } );
	}
	return false;
}

bool fills_the_stack( const MBVH<8>& bvh )
{
	std::vector<std::pair<uint32_t, uint32_t>> todo{ { 0, 0 } };
	while (!todo.empty()) {
		const auto [index, used] = todo.back();
		todo.pop_back();
		const auto& node = bvh.mbvhNode[index];
		if (node.isLeaf()) continue;
		if (used + 8 > STACK) return true;
		for (uint32_t i = 0; i < node.childCount; i++) todo.push_back( { node.child[i], used + node.childCount - 1 } );
	}
	return false;
}

// The steps of BVH8_CPU::Build and BuildHQ, with what they rely on looked at between them.
Refusal build( BVH8_CPU& tree, const bvhvec4slice& vertices, bool hq )
{
	BVH& binary = tree.bvh8.bvh;
	binary.context = tree.bvh8.context = tree.context;
	if (hq) binary.BuildHQ( vertices ); else binary.BuildAVX( vertices );
	if (is_too_deep( binary )) return DEEP;
	binary.PrepareBuild4_8();
	binary.Compact();
	tree.bvh8.ConvertFrom( binary, true );
	if (fills_the_stack( tree.bvh8 )) return DEEP;
	const uint64_t node = sizeof( BVH8_CPU::BVHNode ), leaf = sizeof( BVHTri4Leaf );
	// It counts these bytes in 32 bits.
	if (tree.bvh8.usedNodes * node + tree.bvh8.LeafCount() * leaf > UINT32_MAX) return LARGE;
	tree.ConvertFrom( tree.bvh8 );
	binary.verts = {};
	return NONE;
}

// A ray of tinybvh's, as its constructor makes one: the direction normalised, to begin where it counts. `length` is
// what its parameters are to be divided by. False if it can hit nothing.
inline bool prepare( const Query& query, Ray& ray, float& length )
{
	bvhvec3 d( query.dir[0], query.dir[1], query.dir[2] );
	const bvhvec3 o( query.origin[0], query.origin[1], query.origin[2] );
	ray.O = o + query.t_min * d;
	length = sqrtf( tinybvh_dot( d, d ) );
	if (length > 1e-15f && length < 1e18f) d *= 1 / length; else {
		// The squares were out of range.
		const double x = d.x, y = d.y, z = d.z, precise = sqrt( x * x + y * y + z * z );
		length = (float)precise;
		d = bvhvec3( (float)(x / precise), (float)(y / precise), (float)(z / precise) );
	}
	ray.D = d, ray.rD = tinybvh_rcp( d );
	// An infinite end means the largest float.
	const float end = ((query.t_max > FLT_MAX ? FLT_MAX : query.t_max) - query.t_min) * length;
	ray.hit.t = end < FARTHEST ? end : FARTHEST;
	const auto is_near = []( float x ) { return fabsf( x ) < FARTHEST; };
	return length > 0 && is_near( ray.O.x ) && is_near( ray.O.y ) && is_near( ray.O.z ) && !std::isnan( d.x + d.y + d.z + end );
}

} // namespace

extern "C" uint32_t srt_tinybvh_build( const float* corners, uint32_t triangles, bool hq, uint32_t threads, void** built )
{
	BVH8_CPU* tree = 0;
	try {
		Processors processors( threads );
		const bool several = threads > 1 && processors.may_be_several && std::thread::hardware_concurrency() > 0;
		threaded_from = several ? THREADED_FROM : UINT32_MAX;
		std::unique_ptr<Pools> pools( several && triangles >= THREADED_FROM ? new Pools() : 0 );
		tree = new BVH8_CPU();
		const bvhvec4slice vertices( (const bvhvec4*)corners, 3 * triangles, sizeof( bvhvec4 ) );
		const Refusal refusal = build( *tree, vertices, hq );
		if (refusal == NONE) *built = tree; else delete tree;
		return refusal;
	}
	catch (...) { delete tree; return MEMORY; }
}

extern "C" void srt_tinybvh_free( void* tree ) { delete (BVH8_CPU*)tree; }

extern "C" void srt_tinybvh_facts( const void* built, Facts* facts )
{
	const BVH8_CPU& tree = *(const BVH8_CPU*)built;
	const MBVH<8>& wide = tree.bvh8;
	const BVH& binary = wide.bvh;
	facts->bytes = tree.allocatedBlocks * 64ull + wide.allocatedNodes * sizeof( MBVH<8>::MBVHNode )
		+ binary.allocatedNodes * sizeof( BVH::BVHNode ) + binary.idxCount * (4ull + sizeof( BVHBase::Fragment ));
	facts->spatial = !binary.refittable, facts->threaded = binary.threadedBuild;
}

extern "C" void srt_tinybvh_closest( const void* built, const Query* rays, size_t count, Found* hits )
{
	const BVH8_CPU& tree = *(const BVH8_CPU*)built;
	for (size_t i = 0; i < count; i++) {
		Ray ray;
		float length;
		hits[i] = { INFINITY, UINT32_MAX, UINT32_MAX, 0, 0 };
		if (!prepare( rays[i], ray, length )) continue;
		ray.hit.prim = UINT32_MAX;
		tree.Intersect( ray );
		if (ray.hit.prim == UINT32_MAX) continue;
		hits[i] = { ray.hit.t / length + rays[i].t_min, 0, ray.hit.prim, ray.hit.u, ray.hit.v };
	}
}

extern "C" void srt_tinybvh_any( const void* built, const Query* rays, size_t count, bool* blocked )
{
	const BVH8_CPU& tree = *(const BVH8_CPU*)built;
	for (size_t i = 0; i < count; i++) {
		Ray ray;
		float length;
		blocked[i] = prepare( rays[i], ray, length ) && tree.IsOccluded( ray );
	}
}
